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

#include "dem/fast/chunk.h"
#include "dem/surfaces/near_faces.h"

/* The history of a contact, for the next step. */
struct surface_history {
    int owner, id;
    double n[3];          /* [-] */
    double xi[3];         /* [m] the spring */
    double roll_angle[3]; /* [rad] that of rolling friction, if there is any */
};

/* Owners in ascending order. */
struct surface_histories {
    int n, capacity;
    struct surface_history *list;
};

/* What one surface received from the particles of the chunk, over all steps. */
struct surface_received {
    double impulse[3]; /* [N s] */
    double angular[3]; /* [N m s] about the centre of its motion */
    double work;       /* [J] that it did on the particles */
    double force[3];   /* [N] when the loads were last computed */
    double torque[3];  /* [N m] */
};

struct surface_contacts {
    struct near_faces list, close;
    struct surface_contact_points touches;
    struct surface_histories current, previous, saved;
    struct row_place *place;   /* as in struct bodies: the two spheres of */
    struct row_motion *motion; /* contact q are 2 q and 2 q + 1 */
    struct chunk pairs;        /* the contacts in the layout of the loop */
    int *material;             /* [-] of these; where there are several */
    int capacity;              /* [-] contacts that fit in */
    struct pose *pose;         /* of each surface, at `time` [s] */
    struct pose *built;        /* at the last rebuild of the list */
    double time, built_time;   /* [s] */
    struct surface_received *received;
    double power[ENERGY_PARTS + 1]; /* [W] of the surfaces: parts, all */
};

void surface_contacts_init(struct surface_contacts *c,
                           const struct surface_scene *scene);
void surface_contacts_release(struct surface_contacts *c);

/* Computes the contacts: adds their loads to the chunk and to the totals of
 * each surface; tangential displacements and totals advance by dt [s]. */
void surface_contacts_add_loads(struct surface_contacts *c,
                                const struct surface_scene *scene,
                                struct chunk *s, const struct bodies *b,
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
