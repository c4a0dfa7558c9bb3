/* strip.h -- the particles in strips, and who is near whom.  Chapter 3.
 *
 * The particles, sorted in space, are cut into strips. How many depends on the
 * number of particles alone and never on the number of threads: each strip is
 * one thread's work, sums its own loads, and the loads that it lays on
 * particles of the next strips are added there in a fixed order. So the result
 * has the same bits for any number of threads.
 *
 * A strip keeps two lists. Its vicinity has every pair closer than the skin,
 * gap <= s [LS 5.15], and holds for as long as nobody moved s/2. Its contacts
 * are the few of them closer than a small margin: they are what each step
 * computes, without asking again who touches whom, until the particles may
 * have moved that margin. A pair belongs to the strip of its first particle.
 */
#ifndef STRIP_H
#define STRIP_H

#include "particles/bodies.h"

/* Partners of the particles begin, begin + 1, ... of a strip: those of the
 * a-th are partner[start[a]] ... partner[start[a + 1] - 1]. */
struct vicinity {
    int *start, *partner;
    double (*spring)[3]; /* [m] xi of the pair while it is no contact */
    double (*roll)[3];   /* [rad] theta likewise; NULL without rolling */
    int n, capacity;
};

/* Pairs first, then walls. The partner of a wall contact is the wall, 2 k for
 * the lower and 2 k + 1 for the upper one of direction k. */
struct contacts {
    int n_pairs, n_walls, capacity;
    int *owner, *partner;
    int *source;       /* [-] its place in the vicinity */
    double *spring[3]; /* [m] xi, x y z */
    double *roll[3];   /* [rad] theta (sweep_rolling.h); NULL without it */
};

/* A touching pair while the lists are made anew; wall: partner = -1 - wall. */
struct kept {
    int owner, partner;
    double spring[3]; /* [m] */
    double roll[3];   /* [rad] */
};

/* A strip is worked through in blocks of STRIP_BLOCK particles: the contacts
 * that they own, then their motion, while all of it is still in the cache. Each
 * number counts from the beginning of the strip to the end of the block. */
struct block {
    int end;          /* its last particle + 1 */
    int pairs, walls; /* [-] contacts done with it: at least its own */
    int reach;        /* [-] loads that these touch */
};

/* What a report says of a strip. */
struct strip_measures {
    int contacts;                 /* [-] that touch */
    double translation, rotation; /* [J] kinetic energy */
    double speed2;                /* [m^2/s^2] largest v^2 */
};

/* The energy budget of a strip (energy.h); zero unless it is asked for. */
struct strip_energy {
    /* of the last sweep */
    double normal;     /* [J] sum of elastic(delta) delta */
    double tangential; /* [J] sum of (1/2) k_t xi^2 */
    double found;      /* [J] the same before the step, with the k_t of now */
    double stored;     /* [J] and as the sweep before left it */
    int looks;         /* [-] 1: this sweep books nothing as released */
    /* since the first */
    double damped_n, damped_t; /* [J] by the dashpots */
    double slid;               /* [J] by friction where it slides */
    double released;           /* [J] by tangential springs */
    double rolled;             /* [J] against rolling friction */
    double work;               /* [J] of the outside forces */
    double attracted;          /* [J] work of the attractions */
};

/* The deepest overlap so far, if it is deeper than one wants to know of. */
struct strip_deep {
    double overlap; /* [-] over the mean diameter; only deeper ones are noted */
    int id, other;  /* [-] of whom; -1: none yet. -1 - w: wall w = 2 k or 2 k +
                       1 of direction k; -7 - f: surface f */
    double at[3];   /* [m] centre of the first */
};

struct strip {
    int begin, end;    /* its particles */
    int window;        /* its loads reach begin ... begin + window - 1, modulo
                          the number of particles */
    double (*load)[8]; /* [N] F, 0, sum n x F_t (r/(R_i + R_j)), 0 */
    int load_capacity;
    struct vicinity pairs, walls;
    struct contacts contacts;
    struct block *blocks;
    int n_blocks;
    struct kept *kept;
    int n_kept, kept_capacity;
    int rolls;      /* [-] 1: there is rolling friction */
    double deepest; /* [-] largest overlap over the mean diameter */
    struct strip_deep deep;
    double fastest[4]; /* [m/s] largest |v_x|, |v_y|, |v_z| */
    double so_far[4];  /* [m/s] the same in the step at hand */
    struct bodies_survey survey;
    struct strip_measures measures;
    struct strip_energy energy;
};

/* How many strips n particles are cut into. */
int strip_count(int n);

void strip_release(struct strip *s);

/* Sets begin and end for strip number s of `count`. */
void strip_cut(struct strip *s, int number, int count, int n);

/* Empties the vicinity; adds to it, owner after owner in ascending order. */
void strip_clear(struct strip *s);
void strip_begin_owner(struct strip *s, int i);
void strip_add_pairs(struct strip *s, int n, const int *partner);
void strip_add_wall(struct strip *s, int wall);
void strip_close(struct strip *s, int n);

/* Chooses the contacts from the vicinity: gap < margin [m]. The springs go
 * from the old contacts to the vicinity and from there to the new contacts. */
void strip_choose(struct strip *s, const struct bodies *b, double margin);

/* Room for n remembered pairs; those that there are stay. */
void strip_reserve_kept(struct strip *s, int n);

/* Remembers the touching pairs; puts one back that strip s owns now. */
void strip_keep(struct strip *s);
void strip_restore(struct strip *s, const struct kept *k);

/* How many of the first particles of strip s bear loads from strip t; n
 * particles in all. */
int strip_reached(const struct strip *s, const struct strip *t, int n);

/* Adds the loads that the other strips laid on particles begin ... end - 1 of
 * strip s. */
void strip_fold(struct strip *strips, int count, int s, int n, int begin,
                int end);

/* Fills in the measures. */
void strip_measure(struct strip *s, const struct bodies *b);

/* Notes an overlap that is deeper than all before. */
void strip_note(struct strip_deep *d, double overlap, int id, int other,
                const double x[3]);

/* Looks for it among the contacts between two blocks, where they are now. */
void strip_look_deep(struct strip *s, const struct bodies *b,
                     const struct block *from, const struct block *to);

/* Power of the loads of this strip on the particles of now [W]. */
double strip_power(const struct strip *s, const struct bodies *b);

/* Adds to the energy budget what the outside forces did in a drift of dt of the
 * particles begin ... end - 1. */
void strip_work(struct strip *s, const struct bodies *b, int begin, int end,
                double dt);

/* Around all contacts of a step. Springs wander between strips when the lists
 * are made anew: `released` of one strip may be anything, the sum over all is
 * right. */
void strip_open_budget(struct strip_energy *e);
void strip_close_budget(struct strip_energy *e);

#endif
