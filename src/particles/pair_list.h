/* pair_list.h -- who may touch whom, and what they remember.  Chapter 2.
 *
 * A list of pairs (i, j): particles with i < j, or a particle i and a wall j.
 * It holds all pairs closer than touching plus the skin [LS 5.15] and stays
 * good until a particle has moved half the skin.
 *
 * The particles, sorted in space, are cut into strips, the same for any number
 * of threads; the pairs of a strip are those whose i is in it, and j is at
 * most one strip further. A strip is worked on by one thread and adds the
 * forces on its own particles to `own` and those on the next strip's to
 * `spill`: no two threads write to the same place, and each sum has one order.
 */
#ifndef PAIR_LIST_H
#define PAIR_LIST_H

enum { MOST_STRIPS = 16 };

struct pair_list {
    int n, capacity;
    int n_strips;
    int start[MOST_STRIPS + 1];          /* [-] first pair of a strip */
    int particle_start[MOST_STRIPS + 1]; /* [-] first particle of a strip */
    int *i, *j;
    double *s;               /* [m] tangential spring, 3 a pair */
    unsigned char *touching; /* [-] 1: s is in use */
    double period[3];        /* [m] 0 where the box is not periodic */
    double low[3], high[3];  /* [m] the walls */
};

/* Where a strip puts forces and torques, and what it notices. */
struct strip_forces {
    double *own[6], *spill[6]; /* [N], [N m] x y z of each */
    int contacts;
    double max_overlap; /* [-] of the mean diameter */
};

/* A pair that has parted remembers nothing. */
static inline void pair_list_forget(struct pair_list *l, int e)
{
    if (!l->touching[e]) return;
    l->touching[e] = 0;
    l->s[3 * e] = l->s[3 * e + 1] = l->s[3 * e + 2] = 0.0;
}

void pair_list_init(struct pair_list *l);
void pair_list_release(struct pair_list *l);

/* Room for n pairs; what is in the list is lost. */
void pair_list_reserve(struct pair_list *l, int n);

#endif
