/* interrupt.h -- how a run ends on a signal.
 *
 * Ctrl-C, SIGTERM and SIGHUP are held back for the whole program. While the
 * case is read and built there is nothing to save: a thread that only waits for
 * them ends the program at once. During the run the loop checks for a signal
 * after each step, so that a step is never left half done. No handler and no
 * variable that one would change is needed.
 */
#ifndef BASE_INTERRUPT_H
#define BASE_INTERRUPT_H

#include <pthread.h>

/* The exit code of a program that was ended by a signal. */
enum { INTERRUPT_CODE = 130 };

/* Holds the signals back; before the first thread is started. A SIGHUP that is
 * ignored, as under nohup, stays ignored. SIGPIPE is ignored from now on: a
 * closed pipe behind the progress bar does not end a run. */
void interrupt_hold(void);

/* 1 once one of them has arrived. */
int interrupt_arrived(void);

/* 1 if SIGUSR1 has arrived since the last call: the state is to be saved, and
 * the run goes on. */
int interrupt_asks_to_save(void);

/* Discards the signals that have arrived; only later ones count. */
void interrupt_take(void);

/* The state of the waiting thread. */
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
