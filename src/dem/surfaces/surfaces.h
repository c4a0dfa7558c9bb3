/* surfaces.h -- all surfaces of a run, for the loop over its steps.
 * Chapter "Walls".
 *
 * One surface_contacts a chunk, so that each thread has its own and the sums
 * have the same bits for any number of threads. Functions with a chunk number s
 * are called by the thread that works on this chunk.
 */
#ifndef DEM_SURFACES_SURFACES_H
#define DEM_SURFACES_SURFACES_H

#include "dem/dem.h"
#include "dem/surfaces/motion.h"
#include "dem/surfaces/surface_contacts.h"

struct surfaces {
    struct surface_scene scene;
    struct surface_contacts *chunk;
    int n_chunks;       /* [-] chunks */
    double speed;       /* [m/s] no point of a surface in the box is faster */
    int carried;        /* [-] 1: one of them has a carrier (motion.h) */
    struct wear wear;   /* of those that wear */
    int *index_of_id;   /* [-] index of each id after a sort, or -1 */
    int index_capacity; /* [-] ids that there is room for in index_of_id */
};

/* The list and the box are borrowed. */
struct surfaces *surfaces_create(const struct surface *list, int n,
                                 const struct box_domain *box, int count);
void surfaces_free(struct surfaces *sf);

/* Moves the surfaces to their positions at time t [s]. */
void surfaces_move(struct surfaces *sf, int s, double t);

/* Gives those under load the velocity from t [s] on, from the forces before it;
 * by one thread. */
void surfaces_follow_loads(struct surfaces *sf, double t);

/* How far any of them may have moved since surfaces_find [m]. */
double surfaces_moved(const struct surfaces *sf, int s);

/* At a rebuild of the lists: the histories are saved with the ids of their
 * particles; one thread finds the new indices; then faces are found, and the
 * histories are restored. */
void surfaces_save_history(struct surfaces *sf, int s,
                           const struct particles *ps);
void surfaces_locate_particles(struct surfaces *sf, const struct particles *ps);
void surfaces_find(struct surfaces *sf, int s, const struct chunk *chunk,
                   const struct rows *b, double skin);
void surfaces_choose_contacts(struct surfaces *sf, int s, const struct rows *b,
                              double margin);
void surfaces_add_loads(struct surfaces *sf, int s, struct chunk *chunk,
                        const struct rows *b, const struct contact_constants *k,
                        double dt);

/* Adds what a step of dt [s] did to the faces of those that wear, after the
 * loads of all chunks; by one thread. */
void surfaces_wear(struct surfaces *sf, double dt);

/* Adds to the survey the particles that are in the solid of a plane or cylinder
 * by more than their radius and, if `marks` says that the positions at the last
 * rebuild are known, those whose path since then crosses a triangle. */
void surfaces_check_lost(const struct surfaces *sf, int s,
                         const struct chunk *chunk, const struct rows *b,
                         int marks, double skin, struct rows_survey *found);

/* Visits all that the next run depends on (state.h). */
void surfaces_state(struct surfaces *sf, const struct chunk *chunks, int most,
                    struct state *s);

/* Before a run. */
void surfaces_begin_run(struct surfaces *sf);

/* The totals of a surface over all chunks. */
struct surface_received surfaces_received(const struct surfaces *sf,
                                          int surface);

/* --- surface history: the springs of surfaces among all springs.
 *
 * They stand at the end of the list that dem_histories gives.
 */

/* Their number; written to the list unless it is NULL. Of the particles ps, or
 * NULL for those that the next run starts with. No surfaces, no springs. */
int surface_history_list(struct surfaces *sf, const struct particles *ps,
                         struct dem_history *list);

/* The next run starts with those at the end of the list of n: their number. */
int surface_history_restore(struct surfaces *sf, const struct dem_history *list,
                            int n);

/* --- surfaces checksum: the checksum of the surfaces that a bed rests on. */

/* CRC-32 over the shapes of the surfaces at time 0, their triangles and what
 * material 0 is against theirs; 0 if there are no surfaces. */
unsigned long surfaces_checksum(const struct dem_options *o);

/* --- dem surface: what the particles do to a surface. */

/* Impulse and work of the particles on surface k since the run began. */
struct dem_surface {
    double impulse[3]; /* [N s] force over time */
    double angular[3]; /* [N m s] torque about the centre of its motion */
    double work;       /* [J] that it did on the particles */
    double force[3];   /* [N] at the end of the last run */
    double t;          /* [s] the time of the motions */
    struct pose pose;  /* where it is */
};
struct dem_surface dem_surface(const struct dem *dem, int k);

/* What the particles did to the faces of surface k; NULL: it does not wear. */
const struct wear_face *dem_surface_wear(const struct dem *dem, int k);

#endif
