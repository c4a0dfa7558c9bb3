/* snapshot.h -- a copy of the last valid state.
 *
 * It is copied at each row of the history. All files with fields and particles
 * are written from it: so when a step breaks down, the files at the end show
 * the last valid state.
 */
#ifndef RECORD_SNAPSHOT_H
#define RECORD_SNAPSHOT_H

#include "coupling/simulation.h"
#include "output/folder.h"
#include "output/vtk.h"

/* A further number, or vector, of each particle. */
struct snapshot_field {
    const char *name, *unit;
    int components; /* [-] 1 or 3 */
    void (*take)(void *memory, const struct simulation *sim, double *to);
};
enum { SNAPSHOT_FIELDS = 8, SNAPSHOT_WORD = 64 };

/* All that a case may ask for, ended by one without a name
 * (particle_fields.c). */
extern const struct snapshot_field snapshot_fields[];

struct snapshot {
    double t; /* [s] */
    /* Fluid; NULL without one. */
    double *eps;   /* [-] */
    double *eps_s; /* [-] */
    double *u;     /* [m/s] 3 a cell */
    double *p;     /* [Pa] */
    double *u_s;   /* [m/s] mean velocity of the particles, 3 a cell; 0 where
                      there are none */
    /* Particles; n = 0 without any. */
    int n, capacity;
    double *x[3];  /* [m] */
    double *v[3];  /* [m/s] */
    double *w[3];  /* [rad/s] */
    double *d;     /* [m] */
    double *speed; /* [m/s] */
    int *id;
    int *material; /* [-] NULL where all are of one */
    /* What folders add (recorder_part.h). */
    int n_more;
    const struct snapshot_field *more[SNAPSHOT_FIELDS];
    void *memory[SNAPSHOT_FIELDS];
    double *value[SNAPSHOT_FIELDS];
    int *order; /* [-] work space where the particles are in the order of their
                   ids; NULL: as the program has them */
};

struct snapshot *snapshot_create(const struct simulation *sim);
/* All of it (state.h). */
void snapshot_state(struct snapshot *s, const struct mesh *mesh,
                    struct state *state);
/* Copies the present state of the simulation. */
void snapshot_take(struct snapshot *s, const struct simulation *sim);
/* Adds a field, which is computed with `memory`; before the first step. */
void snapshot_add(struct snapshot *s, const struct snapshot_field *field,
                  void *memory);
/* From now on the particles are in the order of their ids. */
void snapshot_order_by_id(struct snapshot *s);

/* --- field output: the files that ParaView shows, written from a snapshot. */

struct field_output;

/* The collections of the phases of the simulation, of unstructured grids alone
 * if `grids` is not 0; NULL after a message. */
struct field_output *field_output_create(const struct simulation *sim,
                                         struct folder *folder, int grids);
void field_output_free(struct field_output *p);

/* The arrays of the files besides cells and centres. Both return their number.
 */
enum { FIELD_OUTPUT_ARRAYS = 16 };
int field_output_of_fluid(const struct simulation *sim,
                          const struct snapshot *s,
                          struct vtk_array arrays[FIELD_OUTPUT_ARRAYS]);
int field_output_of_particles(const struct snapshot *s,
                              struct vtk_array arrays[FIELD_OUTPUT_ARRAYS]);

/* Non-zero after a message. */
int field_output_add(struct field_output *p, const struct snapshot *s);

/* The files so far (state.h). */
void field_output_state(struct field_output *p, struct state *s);

/* The time of the last one [s]; -1 before the first. */
double field_output_last(const struct field_output *p);

#endif
