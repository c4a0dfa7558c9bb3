/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/interrupt.h"

#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

static const int ending[] = {SIGINT, SIGTERM, SIGHUP};
enum { N_ENDING = sizeof ending / sizeof ending[0] };

/* A blocked signal waits even where it is ignored. A shell makes its background
 * jobs ignore SIGINT, but a SIGINT that is sent to a process by its number is
 * meant for it; SIGHUP is ignored only on request. */
static int interrupt_is_wanted(int number)
{
    struct sigaction now;

    return number != SIGHUP || sigaction(number, NULL, &now) != 0 ||
           now.sa_handler != SIG_IGN;
}

static void set_of(sigset_t *set)
{
    sigemptyset(set);
    for (int i = 0; i < N_ENDING; i++)
        if (interrupt_is_wanted(ending[i])) sigaddset(set, ending[i]);
}

void interrupt_hold(void)
{
    sigset_t held;

    set_of(&held);
    sigaddset(&held, SIGUSR1);
    pthread_sigmask(SIG_BLOCK, &held, NULL);
    signal(SIGPIPE, SIG_IGN);
}

int interrupt_arrived(void)
{
    sigset_t waiting;
    int arrived = 0;

    sigemptyset(&waiting);
    sigpending(&waiting);
    for (int i = 0; i < N_ENDING; i++)
        arrived |= sigismember(&waiting, ending[i]) == 1;
    return arrived;
}

int interrupt_save_requested(void)
{
    const struct timespec at_once = {0, 0};
    sigset_t set;

    sigemptyset(&set);
    sigaddset(&set, SIGUSR1);
    return sigtimedwait(&set, NULL, &at_once) > 0;
}

void interrupt_discard(void)
{
    const struct timespec at_once = {0, 0};
    sigset_t set;

    set_of(&set);
    while (sigtimedwait(&set, NULL, &at_once) > 0)
        ;
}

/* Once a signal is taken the thread is not cancelled any more, or the signal
 * would be lost. */
static void *wait_for_one(void *watch)
{
    const struct interrupt_watch *const w = watch;
    sigset_t set;
    int number, before;

    set_of(&set);
    while (sigwait(&set, &number) != 0)
        ;
    pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before);
    if (w->clean_up != NULL) w->clean_up(w->data);
    fputs("winnow: interrupted before the run began\n", stderr);
    _exit(INTERRUPT_CODE);
}

void interrupt_watch_begin(struct interrupt_watch *w,
                           void (*clean_up)(void *data), void *data)
{
    w->clean_up = clean_up;
    w->data = data;
    w->is_running = pthread_create(&w->thread, NULL, wait_for_one, w) == 0;
}

void interrupt_watch_end(struct interrupt_watch *w)
{
    if (!w->is_running) return;
    pthread_cancel(w->thread);
    pthread_join(w->thread, NULL);
    w->is_running = 0;
}
