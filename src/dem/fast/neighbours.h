/* neighbours.h -- when and how the lists are rebuilt.
 * Chapter "Neighbours".
 *
 * The gap of two particles with speeds of at most v decreases by at most 2 v dt
 * in a step [LS 5.16]. The contacts are chosen with a margin of each particle,
 * by which it may move until they are chosen again; while the sum of v dt is
 * below the least margin, no other pair can touch. Then it is measured whether
 * a particle has used up its own. If so the contacts are chosen again from the
 * neighbour list, which is complete while no particle is farther than half of
 * the skin from where it was listed. When that leaves no room for a margin, the
 * particles are sorted and the neighbour list is rebuilt; contact histories
 * stay with their pairs.
 *
 * All threads of a team call these functions together; each thread works on its
 * range of chunks.
 */
#ifndef DEM_FAST_NEIGHBOURS_H
#define DEM_FAST_NEIGHBOURS_H

#include "dem/attraction.h"
#include "dem/clumps.h"
#include "dem/fast/chunk.h"
#include "dem/particles.h"
#include "dem/surfaces/prescribed_particles.h"
#include "dem/surfaces/surfaces.h"

/* --- barrier -------------------------------------------------------------- */

/* A barrier for the threads of a team.
 *
 * OpenMP's own barrier spins for a long time: this is fast on an idle machine,
 * but on a busy one each wait can last until the scheduler takes the processor
 * away, and a particle step has two barriers. This barrier spins for a
 * fraction of a millisecond and then sleeps. */

struct barrier;

struct barrier *barrier_create(void);
void barrier_free(struct barrier *b);

/* Returns when as many threads as `team` have called it. */
void barrier_wait(struct barrier *b, int team);

/* --- grid ----------------------------------------------------------------- */

/* Particles sorted into cells, and the pairs found there.
 *
 * The cells are as wide as the largest distance of a pair in the neighbour
 * list, so that the partners of a particle are in its own cell and the 26
 * around it. The particles are numbered cell by cell, with the longest
 * direction of the box as the slowest index: particles that are close in space
 * are then close in memory. */

struct grid;

struct grid *grid_create(int capacity, const struct box_domain *box);
void grid_free(struct grid *g);

/* Finds the order of the particles with cells of at least `reach` [m], at the
 * places where they will be after `ahead` [s]: the particle at order[i] belongs
 * to place i. Borrowed; until the next call. `cell` is to work in. */
const int *grid_order(struct grid *g, const struct particles *ps, double reach,
                      double ahead, int *cell);

/* Fills the neighbour list of a chunk with pairs and walls closer than skin
 * [m] there. The rows are in the order of grid_order. */
void grid_find(const struct grid *g, struct chunk *s, const struct rows *b,
               double skin);

/* 1 if particle i owns its pair with j: the particle with the smaller index
 * does or, where the slowest direction is periodic, the one from which the
 * index of the other is reached in fewer steps upward. */
int grid_owns(const struct grid *g, int i, int j, int n);

/* --- neighbours ----------------------------------------------------------- */

struct neighbours {
    struct particles *ps; /* borrowed */
    struct rows *rows;
    struct grid *grid;
    struct chunk *chunks;
    int n_chunks;              /* [-] chunks */
    struct surfaces *surfaces; /* besides the box; NULL without any */
    struct prescribed_particles
        *prescribed;          /* particles with a motion of their own; NULL */
    double (*clump_speed)[3]; /* [m/s] largest |v_x|, |v_y|, |v_z| of balls of a
                                 slice (fast_clumps.c); NULL */
    struct barrier *barrier;
    struct row_load *ring; /* two for each thread */
    int n_rings;           /* [-] threads that have them */
    int ring_size;         /* [-] loads in one */
    const int *order;      /* [-] of the last sort; borrowed from the grid */
    int *rank;             /* [-] new index of each particle after a sort */
    double skin;     /* [m] set by the caller before neighbours_begin_run */
    double smallest; /* [m] diameter; 0: not known yet */
    double range;    /* [m] gap up to which the neighbour list must be complete,
                        for forces at a distance; 0 without any */
    double margin;   /* [m] by which every gap may decrease */
    double margin_used; /* [m] of it since it was measured */
    double ahead;       /* [s] of the places of the list */
    int stale;          /* [-] 1: the particles were changed from outside */
    int history_given;  /* [-] 1: the histories were set by
                           fast_restore_histories, not by the last run */
    long rebuilds;
};

struct neighbours *neighbours_create(struct particles *ps,
                                     const struct box_domain *box);
void neighbours_free(struct neighbours *nb);

/* Adds the rolling angle to the contacts. To be called before the first run. */
void neighbours_add_rolling(struct neighbours *nb);

/* From now on the deepest overlap beyond this fraction of the mean diameter is
 * recorded with its place and its two particles; HUGE_VAL: none is. */
void neighbours_watch(struct neighbours *nb, double overlap);

/* Chunks first ... last - 1 belong to this thread. */
struct chunk_range {
    int first, last;
};
struct chunk_range neighbours_part(int n); /* of n, the same number for each */
struct chunk_range neighbours_static_range(const struct neighbours *nb);

/* The same by the work in a step, which is not distributed evenly. Between uses
 * of the two partitions there must be a barrier. */
struct chunk_range neighbours_balanced_range(const struct neighbours *nb);

/* The chunk of particle i: its begin is n s / count, rounded down. */
static inline struct chunk *neighbours_chunk_of(const struct neighbours *nb,
                                                int i)
{
    return &nb->chunks[((i + 1L) * nb->n_chunks - 1) / nb->rows->n];
}

/* Waits for all threads of the team. */
void neighbours_barrier(const struct neighbours *nb);

/* Before a team of so many threads starts. */
void neighbours_begin_run(struct neighbours *nb, int team);

/* At the beginning and the end of a run: copies the particles to the rows,
 * and back. */
void neighbours_load(struct neighbours *nb);
void neighbours_store(struct neighbours *nb);

/* Largest speed that the last rows_advance of any chunk bounds [m/s]. */
double neighbours_speed(const struct neighbours *nb);

/* By how much every gap may still decrease [m]: twice what is left of the least
 * margin; or -1 if one is used up. found = 1: the last step has looked. */
double neighbours_margin_left(const struct neighbours *nb, int found);

/* Chooses the contacts, with a margin of `least` [m] and `time` |v| for each
 * particle, or what the skin allows, and rebuilds the neighbour list if
 * necessary. Ends with a barrier. Returns by how much every gap may decrease,
 * or -1 if a particle is lost. */
double neighbours_refresh(struct neighbours *nb, double least, double time);

/* Searches the chunks of this thread for lost particles. */
void neighbours_check_lost(struct neighbours *nb);

/* All terms of the budget but `added`, summed over the chunks. */
struct energy neighbours_energy(const struct neighbours *nb);

/* The first pair that crossed in the last drift of dt [s]: each particle that
 * moved by more than the smallest radius is compared with all. */
struct dem_crossing neighbours_crossing(const struct neighbours *nb, double dt);

/* --- clumps (fast_clumps.c) ----------------------------------------------- */

/* By one thread: which particles are balls of clumps, after their order has
 * changed. */
void fast_clumps_locate(struct neighbours *nb);
enum { FAST_CLUMPS_SLICES = 64 };

/* By all threads: writes the rows of all balls; begins and ends with a barrier.
 */
void fast_clumps_write(struct neighbours *nb);

/* By all threads, where there are clumps: their motion under the loads of the
 * contacts. The rows have the new velocities at the old places after a kick
 * with a budget, and all is new after the drift; both then end with a barrier.
 */
void fast_clumps_kick(struct neighbours *nb, double kick, int budget);
void fast_clumps_drift(struct neighbours *nb, double drift);

/* --- chunk step ----------------------------------------------------------- */

/* One time step of the chunks of a thread.
 *
 * A chunk is processed in blocks of particles: first the contacts that a block
 * owns, then its motion, while the data are still in the cache. Particles that
 * receive loads from chunks of other threads move after all threads have
 * computed their loads. The order of all sums is the same for any number of
 * threads. */

struct step_parameters {
    const struct contact_constants *constants;
    const struct attraction *attractions;
    int n_attractions;
    int prescribed; /* [-] 1: prescribed particles move */
    double t;       /* [s] time of the positions, for them */
    int budget;     /* [-] 1: of energy (energy.h) */
    double dt; /* [s] step of the tangential displacements; 0: loads alone */
    double kick, drift; /* [s] step of the velocities, and of the positions */
    double from; /* [-] of the kick, from where on the budget counts it */
    int passing; /* [-] 1: another step follows, and no one asks for the loads
                  */
    int look;    /* [-] 1: what is left of the margins is found, too */
};

/* Number of particles at the beginning of chunk s that receive loads from
 * chunks that this thread has not computed yet. A chunk adds loads to later
 * ones; in a periodic direction the first chunk follows the last one, also if
 * there is only one. Forces other than contacts are computed after the blocks.
 * (chunk_loads.c) */
int chunk_loads_shared(const struct neighbours *nb, int s,
                       const struct step_parameters *by);

/* Before the first block of chunk s and after its last one. */
void chunk_loads_begin(const struct neighbours *nb, int s,
                       const struct step_parameters *by);
void chunk_loads_end(const struct neighbours *nb, int s,
                     const struct step_parameters *by);

/* Computes loads and motion. Every thread of the team calls it; it ends with a
 * barrier. */
void chunk_step_load_and_move(struct neighbours *nb,
                              const struct step_parameters *by);

/* Computes the motion alone, from the present loads; called by all threads,
 * too. */
void chunk_step_move(struct neighbours *nb, const struct step_parameters *by);

#endif
