/* interrupt.h -- how a run ends when it is asked to.
 *
 * Ctrl-C, SIGTERM and SIGHUP are held back for the whole program. While the
 * case is read and built there is nothing to save: a thread that does nothing
 * but wait for them ends the program at once, wherever the others are. Once the
 * run has begun, the loop asks after each step whether one has arrived, so that
 * a step is never left half done. No handler and no variable that one would
 * change is needed.
 */
#ifndef INTERRUPT_H
#define INTERRUPT_H

#include <pthread.h>

/* The exit code of a program that was asked to end. */
enum { INTERRUPT_CODE = 130 };

/* Holds the signals back; before the first thread is started. A SIGHUP that is
 * ignored, as under nohup, stays ignored. So is SIGPIPE from now on: that
 * nobody reads the progress any more does not end a run. */
void interrupt_hold(void);

/* 1 once one of them has arrived. */
int interrupt_arrived(void);

/* Takes those that have arrived: from now on only another one counts. */
void interrupt_take(void);

/* What the waiting thread needs. */
struct interrupt_watch {
    pthread_t thread;
    int on;                 /* [-] 1: the thread is there */
    void (*last)(void *of); /* called before the end; NULL: nothing is */
    void *of;               /* borrowed */
};

/* From here to interrupt_watch_end a signal, also one that has arrived before,
 * ends the program: last(of), one line on stderr, INTERRUPT_CODE. Where no
 * thread can be started the signals stay held back. */
void interrupt_watch_begin(struct interrupt_watch *w, void (*last)(void *of),
                           void *of);
void interrupt_watch_end(struct interrupt_watch *w);

#endif
