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
int interrupt_save_requested(void);

/* Discards the signals that have arrived; only later ones count. */
void interrupt_discard(void);

/* The state of the waiting thread. */
struct interrupt_watch {
    pthread_t thread;
    int is_running;               /* [-] 1: the thread exists */
    void (*clean_up)(void *data); /* called before the program ends; or NULL */
    void *data;                   /* of clean_up; borrowed */
};

/* From here to interrupt_watch_end a signal, also one that has arrived before,
 * ends the program: it calls clean_up(data), prints one line on stderr and
 * exits with INTERRUPT_CODE. Where no thread can be started the signals stay
 * held back. */
void interrupt_watch_begin(struct interrupt_watch *w,
                           void (*clean_up)(void *data), void *data);
void interrupt_watch_end(struct interrupt_watch *w);

#endif
