/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/interrupt.h"

#include <signal.h>
#include <stddef.h>

void interrupt_hold(void)
{
    sigset_t held;

    sigemptyset(&held);
    sigaddset(&held, SIGINT);
    sigaddset(&held, SIGTERM);
    sigprocmask(SIG_BLOCK, &held, NULL);
}

int interrupt_arrived(void)
{
    sigset_t waiting;

    sigemptyset(&waiting);
    sigpending(&waiting);
    return sigismember(&waiting, SIGINT) == 1 ||
           sigismember(&waiting, SIGTERM) == 1;
}
