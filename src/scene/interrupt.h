/* interrupt.h -- stopping a run between two steps.
 *
 * Ctrl-C and SIGTERM are held back for the whole program, and the loop asks
 * after each step whether one has arrived. So no handler and no variable that
 * one would change is needed, and a step is never left half done.
 */
#ifndef INTERRUPT_H
#define INTERRUPT_H

/* Holds the signals back; before the first thread is started. */
void interrupt_hold(void);

/* 1 once one of them has arrived. */
int interrupt_arrived(void);

#endif
