/* contact_list.h -- the contacts of a moment, found anew. */
#ifndef CASE_CONTACTS_CONTACT_LIST_H
#define CASE_CONTACTS_CONTACT_LIST_H

#include "coupling/simulation.h"
#include "dem/box_domain.h"

struct contact_constants;
struct link_cells;

struct contact_list {
    const struct simulation *sim; /* borrowed */
    struct box_domain box;
    struct contact_constants *constants; /* of each pair of materials */
    struct link_cells *cells;
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
 * leaves the box. Contacts with surfaces are those of the last step. */
void contact_list_find(struct contact_list *c);

#endif
