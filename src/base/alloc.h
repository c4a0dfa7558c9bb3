/* alloc.h -- memory, or the end of the program if there is none.
 *
 * Every array of the solver comes from here: zeroed, aligned to 64 bytes for
 * vector loads. If memory is exhausted the program ends with a message and exit
 * code 4, so no caller has to handle it. Released with free().
 */
#ifndef BASE_ALLOC_H
#define BASE_ALLOC_H

#include <stddef.h>

/* n items of the given size [bytes], all zero. n = 0 gives a valid pointer. */
void *alloc_zeroed(size_t n, size_t size);

/* n doubles, n ints, all zero. */
double *alloc_doubles(int n);
int *alloc_ints(int n);

/* An array of n items of the given size [bytes] that begins with the first
 * `used` ones of `old`, which is freed; the others are zero. */
void *alloc_grown(void *old, int used, int n, size_t size);

/* A list with room for one more than its n items of the given size [bytes]:
 * itself, or a longer one, where *room items fit in. */
void *alloc_room(void *list, int n, int *room, size_t size);

/* The most memory that this program can have, that of the machine or the limit
 * of the process, and what is left of it at present [byte]. */
double alloc_most(void);
double alloc_left(void);

/* The largest memory that this program has used so far [byte]. */
double alloc_peak(void);

/* --- owner: an object of this size [bytes], all zero, to which arrays belong:
 * owner_free releases them with it. The arrays are as those above;
 * owner_free(NULL) is fine. Where a module has an x_create and no x_free, what
 * it makes is one. */
void *owner_create(size_t size);
void *owner_zeroed(void *owner, size_t n, size_t size);
double *owner_doubles(void *owner, int n);
int *owner_ints(void *owner, int n);
void owner_free(void *owner);

/* An array that was allocated before, and another such object, belong to the
 * owner from now on; they are returned. They may be NULL. */
void *owner_take(void *owner, void *array);
void *owner_join(void *owner, void *part);

#endif
