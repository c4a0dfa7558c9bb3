/* surface_contacts.h -- the forces of surfaces on a chunk's particles.
 * Chapter "Walls".
 *
 * A contact is computed as one of two spheres, by the same loop and law as any
 * other (sweep.h): behind the surface lies a sphere of the same radius
 * that touches it, with the velocity of the surface, and neither 1/R nor 1/m.
 *
 * Its tangential displacement belongs to a point of the particle, not to a
 * face: it is that of the contact that had the same n one step earlier. A
 * particle that slides from one triangle to the next keeps it.
 */
#ifndef DEM_SURFACES_SURFACE_CONTACTS_H
#define DEM_SURFACES_SURFACE_CONTACTS_H

#include "dem/fast/rows.h"
#include "dem/fast/chunk.h"
#include "dem/surfaces/surface.h"

/* --- near faces: the faces of surfaces near each particle.
 *
 * As with pairs (chunk.h) there are two lists for the particles of a chunk:
 * the neighbour list, with all faces of gap <= skin, and from it, chosen every
 * few steps, those that could touch meanwhile. */

/* The surfaces, where they are now, and the box. Borrowed. */
struct surface_scene {
    const struct surface *surface;
    int n;
    const struct box_domain *box;
    int wears, loaded; /* [-] 1: at least one of them does (wear.h), is */
};

struct near_face {
    int surface, face;
    double shift[3]; /* [m] from the particle's position at the last rebuild
                        to the image of it that is near */
};

/* A particle and its faces: face[first] ... face[last - 1]. */
struct near_owner {
    int owner, first, last;
};

/* Owners in ascending order; none without a face. */
struct near_faces {
    int n_owners, owner_capacity, n_faces, face_capacity;
    struct near_owner *owner;
    struct near_face *face;
    struct triangle_list found; /* of one search */
};

void near_faces_release(struct near_faces *l);

/* All faces of gap <= skin [m] to the particles of a chunk; pose has the place
 * of each surface. */
void near_faces_find(struct near_faces *l, const struct surface_scene *scene,
                     const struct pose *pose, const struct chunk *s,
                     const struct rows *b, double skin);

/* Those of `from` with gap < margin [m]. */
void near_faces_choose(struct near_faces *l, const struct near_faces *from,
                       const struct surface_scene *scene,
                       const struct pose *pose, const struct rows *b,
                       double margin);

/* The image of particle i that the face is near to [m]: a particle may have
 * been brought back into a periodic box since the list was made. */
void near_faces_image(const struct near_face *f, const struct rows *b, int i,
                      double x[3]);

/* --- surface contact points: the contact points of a sphere with surfaces,
 * without duplicates.
 *
 * A sphere that lies over the seam of two triangles overlaps both. There is one
 * contact for each point of the wall. Of the faces in the order of their
 * distance r from the centre one counts unless its nearest point, -r n from the
 * centre, lies behind the plane through that of a nearer face, across n',
 *
 *   r' - r n . n' <= flat R                                           (14.5)
 *
 * since then it lies within the overlap with that face. A seam within a plane,
 * an edge, a vertex and a thin plate are thus counted once, and a corner that
 * contains the sphere is correctly counted twice.
 */

struct surface_contact_point {
    int owner, surface, face;
    double r;    /* [m] from the face to the centre */
    double n[3]; /* [-] likewise */
    double q[3]; /* [m] its nearest point */
    double v[3]; /* [m/s] of the surface, there */
    int before;  /* [-] its place in the histories; -1: it has just begun */
    double F_n, worn; /* [N], [m^3] in this step, of a surface that wears */
};

struct surface_contact_points {
    int n, capacity;
    struct surface_contact_point *list;
};

/* All that count, of all owners, in their order and the nearest first. */
void surface_contact_points_find(struct surface_contact_points *t,
                                 const struct near_faces *close,
                                 const struct surface_scene *scene,
                                 const struct pose *pose, const struct rows *b);

/* A point less than this fraction of the radius in front of a plane counts as
 * behind it: faces at an angle below 2.6 degrees count as one [-]. */
static const double surface_contact_points_flat = 1e-3;

/* --- surface contacts ----------------------------------------------------- */

/* The history of a contact, for the next step. */
struct surface_history {
    int owner, id;
    double n[3];          /* [-] */
    double xi[3];         /* [m] the spring */
    double roll_angle[3]; /* [rad] that of rolling friction, if there is any */
    double F_n;           /* [N] of a surface that wears */
};

/* Owners in ascending order. */
struct surface_histories {
    int n, capacity;
    struct surface_history *list;
};

/* What one surface received from the particles of the chunk, over all steps. */
struct surface_received {
    double impulse[3];         /* [N s] */
    double angular[3];         /* [N m s] about the centre of its motion */
    double work;               /* [J] that it did on the particles */
    double force[3];           /* [N] when the loads were last computed */
    double torque[3];          /* [N m] */
    double impedance, damping; /* [kg/s] then, of contacts with one under load:
                                  sums of sqrt(m dF_n/d delta) and eta_n */
};

struct surface_contacts {
    struct near_faces list, close;
    struct surface_contact_points touches;
    struct surface_histories current, previous, saved;
    struct row_place *place;   /* as in struct rows: the two spheres of */
    struct row_motion *motion; /* contact q are 2 q and 2 q + 1 */
    struct row_ball *ball;     /* likewise; NULL without clumps */
    struct chunk pairs;        /* the contacts in the layout of the loop */
    int *material;             /* [-] of these; where there are several */
    int capacity;              /* [-] contacts that fit in */
    struct pose *pose;         /* of each surface, at `time` [s] */
    struct pose *built;        /* at the last rebuild of the list */
    double time, built_time;   /* [s] */
    struct surface_received *received;
    double power[ENERGY_PARTS + 1]; /* [W] of the surfaces: parts, all */
};

/* Zero before; of the surfaces, the arrays belong to the owner. */
void surface_contacts_init(struct surface_contacts *c, void *owner,
                           const struct surface_scene *scene);
void surface_contacts_release(struct surface_contacts *c);

/* Computes the contacts: adds their loads to the chunk and to the totals of
 * each surface; tangential displacements and totals advance by dt [s]. */
void surface_contacts_add_loads(struct surface_contacts *c,
                                const struct surface_scene *scene,
                                struct chunk *s, const struct rows *b,
                                const struct contact_constants *k, double dt);

/* Add the present loads over t [s] to carried surfaces, and to the budget. */
void surface_contacts_push(struct surface_contacts *c,
                           const struct surface_scene *scene, double t);
void surface_contacts_count(struct surface_contacts *c, double t);
void surface_contacts_save(struct surface_histories *f,
                           const struct surface_history *one);

/* By owner; the histories of one owner stay in their order. */
void surface_contacts_sort(struct surface_histories *f);

#endif
