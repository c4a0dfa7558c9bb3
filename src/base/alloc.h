/* alloc.h -- memory that is there or the program ends.
 *
 * Every array of the solver comes from here: zeroed, aligned to 64 bytes for
 * vector loads. Out of memory ends the program with a message and exit code 4,
 * so that no caller carries a ladder of clean-ups. Released with free().
 */
#ifndef ALLOC_H
#define ALLOC_H

#include <stddef.h>

/* n items of the given size [bytes], all zero. n = 0 gives a valid pointer. */
void *alloc_zeroed(size_t n, size_t size);

/* n doubles, n ints, all zero. */
double *alloc_doubles(int n);
int *alloc_ints(int n);

/* What this program can have at most: the memory of the machine, or a limit
 * that is set for the process [byte]. */
double alloc_most(void);

#endif
