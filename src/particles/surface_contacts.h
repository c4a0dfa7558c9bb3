/* surface_contacts.h -- the forces of surfaces on a strip's particles.
 * Chapter 14.
 *
 * A contact is computed as one of two spheres, by the same loop and law as any
 * other (contact_sweep.h): behind the surface lies a sphere of the same radius
 * that touches it, with the velocity of the surface, and neither 1/R nor 1/m.
 *
 * The spring of a contact belongs to a place of the particle, not to a face: a
 * contact goes on with the spring of the one, a step ago, that had its n. So a
 * particle that slides from one triangle to the next keeps it.
 */
#ifndef SURFACE_CONTACTS_H
#define SURFACE_CONTACTS_H

#include "particles/contact.h"
#include "particles/touches.h"

/* What a contact leaves to the next step. */
struct footprint {
    int owner, id;
    double n[3];    /* [-] */
    double xi[3];   /* [m] the spring */
    double roll[3]; /* [rad] and that of rolling friction, where there is any */
};

/* Owners in ascending order. */
struct footprints {
    int n, room;
    struct footprint *list;
};

/* What one surface received from the particles of the strip, over all steps. */
struct surface_account {
    double impulse[3]; /* [N s] */
    double angular[3]; /* [N m s] about the centre of its motion */
    double work;       /* [J] that it did on the particles */
};

struct surface_contacts {
    struct near_faces vicinity, close;
    struct touches touches;
    struct footprints now, before, kept;
    double (*place)[4];  /* as in struct bodies: the two spheres of contact */
    double (*motion)[8]; /* q are 2 q and 2 q + 1 */
    struct strip pairs;  /* the contacts as the loop wants them */
    int *material;       /* [-] of these; where there are several */
    int room;            /* [-] contacts that fit in */
    struct pose *pose;   /* of each surface, at `time` [s] */
    struct pose *built;  /* when the vicinity was made, at `built_time` [s] */
    double time, built_time;
    struct surface_account *account;
};

void surface_contacts_init(struct surface_contacts *c,
                           const struct surface_scene *scene);
void surface_contacts_release(struct surface_contacts *c);

/* The contacts with their law: adds their loads to the strip, keeps their
 * account; springs and account move on by dt [s]. */
void surface_contacts_push(struct surface_contacts *c,
                           const struct surface_scene *scene, struct strip *s,
                           const struct bodies *b, contact_sweep *sweep,
                           const struct contact_constants *k, double dt);

void surface_contacts_remember(struct footprints *f,
                               const struct footprint *one);

/* Orders footprints by owner; those of one owner stay in their order. */
void surface_contacts_sort(struct footprints *f);

#endif
