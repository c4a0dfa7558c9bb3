/* contact_list.h -- the contacts of a moment, found anew. */
#ifndef RECORD_CONTACT_LIST_H
#define RECORD_CONTACT_LIST_H

#include "coupling/simulation.h"
#include "dem/box_domain.h"

struct bodies;
struct contact_constants;
struct link_cells;
struct near_faces;
struct pose;
struct surface_contact_points;

struct contact_list {
    const struct simulation *sim; /* borrowed */
    struct box_domain box;
    struct contact_constants *constants; /* of each pair of materials */
    struct link_cells *cells;
    struct bodies *rows; /* the particles once more, where there are surfaces;
                            else this and the three below are NULL */
    struct pose *pose;   /* of each surface */
    struct near_faces *near;
    struct surface_contact_points *points;
    int n, room;             /* [-] contacts */
    double *x;               /* [m] the two ends of each, 6 */
    double *force, *depth;   /* [N] elastic, [m] */
    int *ids, *corner, *end; /* [-] 2, 2 and 1 each */
    int *index;              /* [-] of both particles, 2 each; or below 0 */
};

/* For a simulation with particles. */
struct contact_list *contact_list_create(const struct simulation *sim);
void contact_list_free(struct contact_list *c);

/* All contacts of particles with each other, the box and surfaces. The force is
 * the elastic normal one, by the law of contact at the present overlap. ids: of
 * the particle, and of the other or -1 - w of wall w, -7 - s of surface s. A
 * line to a wall or surface ends where it is touched; one across a periodic end
 * leaves the box. */
void contact_list_find(struct contact_list *c);

#endif
