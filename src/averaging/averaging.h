/* averaging.h -- from particles to fields and back.
 * Chapter "Averaging".
 *
 * Spreading turns amounts that particles carry (volume, momentum, force) into
 * densities that cells have, and loses nothing [SX15 A.1]. Gathering is its
 * exact adjoint: the work of a force on the gathered velocities is the work of
 * the spread force on the field.
 *
 *     sum_c V_c spread(q)_c = sum_i q_i
 *     sum_i q_i gather(phi)_i = sum_c V_c phi_c spread(q)_c
 *
 * The m numbers of a cell or particle are interleaved, field[m * c + k] and q[m
 * * i + k], and are spread together, which is much cheaper than one by one. The
 * result has the same bits for any number of threads.
 */
#ifndef AVERAGING_AVERAGING_H
#define AVERAGING_AVERAGING_H

#include "base/model.h"
#include "dem/particles.h"
#include "linear/solvers.h"
#include "mesh/mesh.h"

struct interpolation;

/* A box with its own bandwidth, see bandwidth.h. */
struct averaging_region {
    double low[3], high[3]; /* [m] */
    double bandwidth;       /* [m] 0: the pcm field is not diffused */
};

/* Options of a case. 0 or NULL selects the default in brackets. */
struct averaging_options {
    const struct averaging_method *method;     /* of the case */
    const struct interpolation *interpolation; /* of the case, to particles */
    double bandwidth;   /* [m] b of kernel and diffusion; required there */
    double delta_05;    /* [m] in its place, of the case; 0: not given */
    const char *scheme; /* of the diffusion ["exponential"] */
    int steps;          /* [-] in pseudo-time, where the scheme has any [3] */
    double tolerance;   /* [-] tail of the series, or of the solver [1e-6] */
    const char
        *vary; /* of the diffusion: variation of b in space ["uniform"] */
    struct {
        int n;
        const struct averaging_region *item; /* borrowed during create */
    } regions;
    double cap; /* [-] on eps_s, pcm only [none] */
    double
        gradient_bandwidth; /* [m] of averaging_gradient, of the case [none] */
    double own[MODEL_NUMBERS]; /* of the keys that the method alone reads */
    int fields;  /* [-] largest number of fields in one call [8] */
    void *parts; /* of a mesh that is a part of another one, borrowed [none] */
};

/* The members from lost to lost_volume are set by the last bind, those from
 * unsupported (of dpvm by bind) to negative by the last spread, products and
 * worst by the last spread or gather. */
struct averaging_report {
    int lost, lost_id;  /* [-] particles outside the mesh, first one's id */
    int capped;         /* [-] pcm: cells with more solids than the cap */
    double lost_volume; /* [m^3] pcm: solid volume above the cap */
    int unsupported; /* [-] kernel: particles without a cell centre within b */
    double lowest, highest; /* of the first field: eps_s, by convention */
    double negative;        /* [-] of the first field: share of it below 0 */
    int products; /* [-] diffusion: products with the matrix; one of all fields
                     counts once */
    struct solve_report worst; /* diffusion: its least converged step */
};

/* All methods, ended by NULL, and one by its name or NULL. The names for
 * options.scheme are in diffusion.h. */
extern const struct averaging_method pcm_method, dpvm_method, dpvm_cube_method,
    two_grid_method, kernel_method, kernel_gaussian_method, images_method,
    diffusion_method;
/* The variant of images for a mesh that is no box. */
extern const struct averaging_method images_poly_method;
extern const struct averaging_method *const averaging_methods[];
const struct averaging_method *averaging_method_named(const char *name);

/* The keys of the group `averaging` that all methods have. */
extern const struct key averaging_keys[];

struct averaging;
struct averaging_wall;

/* Allocates for ps->capacity particles; nothing is allocated afterwards. Mesh
 * and particles are borrowed. NULL after a message if the options are wrong. */
struct averaging *averaging_create(const struct averaging_method *method,
                                   const struct mesh *mesh,
                                   const struct particles *ps,
                                   const struct averaging_options *o);
void averaging_free(struct averaging *a);

/* Locates the particles; the caller calls this whenever they have moved or
 * changed their order. Non-zero, after a message with its id, if a particle is
 * outside the mesh; then the next call must be another averaging_bind. */
int averaging_bind(struct averaging *a);

/* The two operations. With the volumes, momenta over density and forces of the
 * particles for q, the sums of V field are those of the particles
 * [SX15 A.1a-c]. */
void averaging_spread(struct averaging *, int m, const double *q,
                      double *field);
void averaging_gather(struct averaging *, int m, const double *field,
                      double *q);

/* The gradient of m fields at the particles by the derivative of a Gaussian
 * [EW18 B.4-B.10] (more/kernel_gradient.h), where the options have a
 * gradient_bandwidth; else returns 0 and leaves X. X[3 * (m * i + k) + j] is
 * d field_k / d x_j at particle i. */
int averaging_gradient(struct averaging *a, int m, const double *field,
                       double *X);

/* Tells the averaging that there are solids inside the mesh, borrowed; and the
 * field that is to be interpolated, with values inside these solids: without
 * them the field itself. */
void averaging_set_wall(struct averaging *a, struct averaging_wall *wall);
const double *averaging_extended(struct averaging *a, int m,
                                 const double *field);

/* Fraction of the volume of particle i that is left by the cap of pcm [-]; 1
 * for all other methods. Spreading and gathering do not apply it: the caller
 * multiplies amounts proportional to volume by it, q_i *= fraction_i. */
double averaging_capped_fraction(const struct averaging *a, int i);
void averaging_apply_cap(const struct averaging *a, int m, double *q);

/* Borrowed: the cell of each particle and the particles of each cell, the
 * report. */
const struct cell_of_particle *averaging_cells(const struct averaging *a);
const struct averaging_report *averaging_report(const struct averaging *a);

/* The variant of the method for this mesh. */
const struct averaging_method *
averaging_variant(const struct averaging_method *method,
                  const struct mesh *mesh);

/* sigma [m] and b [m] of the Gaussian that has half its height at the distance
 * delta_05 / 2 [m] [EW18 20]. */
double averaging_sigma(double delta_05);
double averaging_bandwidth(double delta_05);

/* [XS11 3.6], bell-shaped: K = (1 - zeta^2)^4 for |zeta| < 1, else 0. [-] */
double kernel_polynomial(double zeta);

/* [EW18 19] at the distance r [m]: W [1/m^3]. */
double images_kernel(double r, double sigma);

/* The number of diffusion steps needed to avoid undershoots, if the options
 * have fewer; else 0. Needs only an outline of the mesh. */
int averaging_check(const struct averaging_method *, const struct mesh *,
                    const struct averaging_options *);

/* The descriptor of an averaging method.
 *
 * It is included by the methods (pcm.c, kernel.c, ...) and by the list of them;
 * all other files include averaging.h. */

struct averaging_options;
struct averaging_report;
struct cell_of_particle;

/* One row of the table of methods. state is the result of create, which returns
 * NULL after a message that names the wrong option. h is borrowed; the method
 * is o->method. */
struct averaging_method {
    MODEL_MEMBERS;           /* base/model.h */
    int needs_bandwidth;     /* 1: requires options.bandwidth */
    double reach_b, reach_d; /* [-] radius of the neighbourhood of a cell, in
                                bandwidths and in diameters */
    double uniform_widths;   /* [-] bandwidth over the width of the largest cell
                                from which on the field of a uniform bed is
                                uniform to about 2 %; 0: any */
    double gaussian;         /* [-] b of the Gaussian exp(-r^2 / b^2) with the
                                same variance, over the bandwidth; 0: none */
    int has_own_grid;        /* 1: has a grid of its own, with cells of a
                             bandwidth */
    const struct key *own_keys; /* of its tables, the one whose numbers are in
                                   options.own (base/model.h); NULL: none */
    const void *variety; /* for create, of methods that have it in common: the
                            kernel, the body; else NULL */
    void *(*create)(const struct cell_of_particle *h,
                    const struct averaging_options *o);
    void (*free)(void *state);
    void (*bind)(void *state, struct averaging_report *r); /* or NULL */
    void (*spread)(void *state, int m, const double *q, double *field,
                   struct averaging_report *r);
    void (*gather)(void *state, int m, const double *field, double *q,
                   struct averaging_report *r);
    double (*capped_fraction)(const void *state, int i); /* or NULL: 1 */
    /* The variant for polyhedral meshes; NULL if the same functions work there.
     */
    const struct averaging_method *polyhedral;
};

/* Keys of several methods: the bandwidth, and delta_05 in its place. */
extern const struct key averaging_bandwidth_keys[];
extern const struct key averaging_delta_keys[];

/* Solids inside the mesh that particles cannot be in.
 *
 * A method of averaging takes account of the walls of the mesh, not of other
 * solids: what it puts into the cells of these is moved out again, and a field
 * is continued into them before it is interpolated. The two are adjoint, so
 * that the sums of the averaging are conserved. */

struct averaging_wall {
    /* Moves the densities of the closed cells to open ones; sum V field stays.
     */
    void (*move_out)(const struct averaging_wall *self, int m, double *field);
    /* The same field with values in the closed cells; borrowed, until the next
     * call. */
    const double *(*extend)(struct averaging_wall *self, int m,
                            const double *field);
};

#endif
