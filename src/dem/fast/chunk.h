/* chunk.h -- the particles in chunks, and their neighbour lists.
 * Chapter "Neighbours".
 *
 * The particles, sorted in space, are divided into chunks, whose number depends
 * on the number of particles alone and never on the number of threads. Each
 * chunk is computed by one thread, which sums the loads on its particles; the
 * loads on particles of the following chunks are added there in a fixed order.
 * The result therefore has the same bits for any number of threads.
 *
 * A chunk has two lists. Its neighbour list contains every pair closer than the
 * skin, gap <= s [LS 5.15], and is valid until a particle has moved by s/2. Its
 * contacts are the pairs closer than a small margin: each step computes these
 * only, until the particles may have moved by that margin. A pair belongs to
 * the chunk of its first particle.
 */
#ifndef DEM_FAST_CHUNK_H
#define DEM_FAST_CHUNK_H

#include "dem/dem.h"
#include "dem/energy.h"
#include "dem/fast/rows.h"

/* Partners of the particles begin, begin + 1, ... of a chunk: those of the a-th
 * are partner[start[a]] ... partner[start[a + 1] - 1]. */
struct neighbour_list {
    int *start, *partner;
    int n, capacity;
};

/* Pairs first, then walls. The partner of a wall contact is the wall, 2 k for
 * the lower and 2 k + 1 for the upper one of direction k. */
struct chunk_contacts {
    int n_pairs, n_walls, capacity;
    int *owner, *partner;
    int *list_index;       /* [-] its index in the neighbour list */
    double *xi[3];         /* [m] xi, x y z */
    double *roll_angle[3]; /* [rad] theta (contact.h); NULL without it */
};

/* The history of a touching pair while the lists are rebuilt; for a wall
 * partner = -1 - wall. */
struct contact_history {
    int owner, partner;
    double xi[3]; /* [m] */
};

/* A chunk is processed in blocks of CHUNK_BLOCK particles: first the contacts
 * that they own, then their motion, while the data are still in the cache. Each
 * number counts from the beginning of the chunk to the end of the block. */
struct chunk_block {
    int end;          /* its last particle + 1 */
    int pairs, walls; /* [-] contacts up to this block: at least its own */
    int n_loads;      /* [-] loads that these contacts write */
};

/* Quantities of a chunk for the report. */
struct chunk_measures {
    int contacts;                 /* [-] that touch */
    double translation, rotation; /* [J] kinetic energy */
    double speed2;                /* [m^2/s^2] largest v^2 */
};

/* The energy budget of a chunk (energy.h); zero unless it is asked for. */
struct chunk_energy {
    /* of the last sweep */
    double normal;          /* [J] stored by the elastic forces */
    double tangential;      /* [J] sum of (1/2) k_t xi^2 */
    double stored;          /* [J] the same by the previous sweep */
    double released_before; /* [J] `released` then */
    int skip_release;       /* [-] 1: this sweep counts nothing as released */
    double ahead; /* [J] kinetic energy at the time of the positions, less that
                     of the velocities */
    /* since the first */
    double damped_n, damped_t; /* [J] by the dashpots */
    double slid;               /* [J] by friction where it slides */
    double released;           /* [J] by tangential springs */
    double rolled;             /* [J] against rolling friction */
    double work;               /* [J] of the external forces */
    double attracted;          /* [J] work of the attractions */
    double prescribed;         /* [J] by particles that move as prescribed */
};

struct chunk {
    int begin, end; /* its particles */
    int window;     /* its loads reach begin ... begin + window - 1, modulo
                       the number of particles */
    struct row_load *load; /* see chunk_reserve_loads */
    struct row_load *sum;  /* in a step: where they are summed, `load` or a
                              ring */
    int round;             /* [-] bits of a number in it; -1: all */
    int fetched, reached;  /* [-] particles from the first on whose rows are on
                              their way into the cache, and are to be */
    struct row_load (*part)[ENERGY_PARTS]; /* of these loads (energy.h); NULL
                                               without a budget */
    int load_capacity;
    struct neighbour_list pairs, walls;
    struct chunk_contacts contacts;
    struct chunk_block *blocks;
    int n_blocks;
    double (*roll_history)[3]; /* [rad] of each history; NULL without rolling
                                  friction */
    int n_history;
    int has_rolling;         /* [-] 1: there is rolling friction */
    int has_budget;          /* [-] 1: of energy */
    double max_overlap;      /* [-] largest overlap over the mean diameter */
    struct dem_overlap deep; /* so far; only deeper ones are recorded */
    double max_speed[4];     /* [m/s] largest |v_x|, |v_y|, |v_z| */
    double max_speed_now[4]; /* [m/s] the same in the step at hand */
    struct rows_survey survey;
    double margin_left, margin_left_now; /* [m] the least one; -1: none */
    struct rows_margins margins;
    struct chunk_measures measures;
    struct chunk_energy energy;
};

/* Number of chunks for n particles. */
int chunk_count(int n);

void chunk_release(struct chunk *s);

/* Sets begin and end for chunk number s of `count`. */
void chunk_set_range(struct chunk *s, int number, int count, int n);

/* Empties the neighbour list; the following functions add to it, with owners in
 * ascending order. */
void chunk_clear_lists(struct chunk *s);
void chunk_begin_owner(struct chunk *s, int i);

/* Room for so many partners at the end of the list of pairs, which is as long
 * as before; the caller writes some and adds their number to pairs.n. */
int *chunk_room_for_pairs(struct chunk *s, int n);
void chunk_add_wall(struct chunk *s, int wall);
void chunk_finish_lists(struct chunk *s, int n);

/* Chooses the contacts from the neighbour list: the gap is less than the sum of
 * the margins of both, or than that of the one at a wall. A pair that was a
 * contact before keeps its history. */
void chunk_choose_contacts(struct chunk *s, const struct rows *b);

/* Splits its contacts into n_blocks blocks; n particles in all. */
void chunk_split(const struct chunk *s, int n, struct chunk_block *blocks);

/* Visits the budget (state.h). */
void chunk_energy_state(struct chunk_energy *e, struct state *state);

/* Memory for so many bytes where the loads are, which nobody needs while lists
 * are made and contacts chosen: then the histories are there, or the contacts
 * of before. The first `used` bytes are kept. */
void chunk_reserve_loads(struct chunk *s, size_t bytes, size_t used);

/* Memory for n contacts; the first `used` owners and list indices are kept. */
void chunk_reserve_contacts(struct chunk *s, int n, int used);

/* The histories; memory for n, in which existing ones are kept. */
static inline struct contact_history *chunk_history(const struct chunk *s)
{
    return (void *)s->load;
}
void chunk_reserve_history(struct chunk *s, int n);

/* The history of contact q and its rolling angle; 0: it has none. */
int chunk_contact_history(const struct chunk *s, int q,
                          struct contact_history *k, double roll[3]);

/* Saves those of all touching pairs; restores one that chunk s owns now, unless
 * its pair is no contact any more. `roll`: NULL without rolling friction. */
void chunk_save_history(struct chunk *s);
void chunk_restore_history(struct chunk *s, const struct contact_history *k,
                           const double *roll);

/* --- loads (chunk_loads.c) ------------------------------------------------ */

/* Loads that no one needs after the step are summed in a ring, which stays in
 * the cache: the number of a load is taken modulo its size, a power of two and
 * a multiple of CHUNK_BLOCK. The loads that a block reaches for the first time
 * are set to zero there, in the place of those of particles that have moved. */
enum { CHUNK_BLOCK = 512 };

/* Load number q, that of particle begin + q. */
static inline struct row_load *chunk_load(const struct chunk *s, int q)
{
    return &s->sum[q & s->round];
}

/* Before the first block: in `ring` of `most` loads, unless that is too short.
 * After the last one: those on other chunks go where these will find them. */
void chunk_begin_loads(struct chunk *s, struct row_load *ring, int most);
void chunk_end_loads(struct chunk *s);

/* Sets loads number first ... last - 1 to zero. */
void chunk_zero_loads(struct chunk *s, int first, int last);

/* Number of particles at the beginning of chunk s that receive loads from chunk
 * t; n particles in all. */
int chunk_shared_loads(const struct chunk *s, const struct chunk *t, int n);

/* Adds the loads that the other chunks computed for particles begin ... end - 1
 * of chunk s. */
void chunk_add_loads(struct chunk *chunks, int count, int s, int n, int begin,
                     int end);

/* ------------------------------------------------------------------------- */

/* Fills in the measures. */
void chunk_measure(struct chunk *s, const struct rows *b);

/* Records an overlap that is deeper than all before. */
void chunk_record_overlap(struct dem_overlap *d, double depth, int id,
                          int other, const double x[3]);

/* Records the deepest overlap of the contacts between two blocks, at the
 * present positions. */
void chunk_check_overlaps(struct chunk *s, const struct rows *b,
                          const struct chunk_block *from,
                          const struct chunk_block *to);

/* Counts in the budget the work of a kick of `length` [s] from its part `from`
 * to its part `to` [-]; `part` is that of the chunk's first particle on, the
 * velocities before and after it are of all particles (rows.h). */
struct chunk_kick {
    double length, from, to;
    const struct row_motion *before, *after;
    struct row_load (*part)[ENERGY_PARTS];
};
void chunk_count_kick(struct chunk *s, const struct rows *b,
                      const struct chunk_kick *kick);

/* The same from the present velocities up to `to` [-] of the kick of one step
 * that follows, which is not made; and `ahead`, the kinetic energy that it
 * brings. */
void chunk_count_ahead(struct chunk *s, const struct rows *b, double to);
void chunk_measure_ahead(struct chunk *s, const struct rows *b, double to);

/* To be called before and after the contacts of a step. Contact histories
 * migrate between chunks at a rebuild; only the sum of `released` over all
 * chunks is meaningful. */
void chunk_begin_budget(struct chunk_energy *e);
void chunk_end_budget(struct chunk_energy *e);

#endif
