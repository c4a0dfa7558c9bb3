/* insertion.h -- particles that come in while a run goes on.  Chapter 15.
 *
 * A source puts spheres at random places of a region, where they touch nobody:
 * all at once, or so many a second. The k-th sphere has its diameter and its
 * places from random numbers that depend on the seed and on k alone. So a large
 * one that finds no room waits, and the smaller ones behind it with it, or the
 * sizes that come in would not be those that were asked for; and a source is
 * known by two numbers when a run is resumed.
 */
#ifndef INSERTION_H
#define INSERTION_H

#include <stdio.h>

#include "particles/bodies.h"
#include "particles/room.h"
#include "particles/sizes.h"

/* One sphere of a list. */
struct insertion_one {
    double x[3]; /* [m] */
    double d;    /* [m] */
};

struct insertion_options {
    double lo[3], hi[3];       /* [m] the region: whole spheres fit in */
    double velocity[3];        /* [m/s] that they come with */
    double diameter;           /* [m] of all, unless there are sizes */
    const struct sizes *sizes; /* borrowed; or NULL */
    double density;            /* [kg/m^3] */
    int material;              /* [-] its number */
    long count;                /* [-] of spheres in all */
    double rate;               /* [1/s]; 0: all at once */
    double start;              /* [s] time of the first */
    unsigned long seed;
    struct room room;                 /* places without room count as tried */
    const struct insertion_one *list; /* borrowed; count of them, instead of
                                         chance; or NULL */
};

struct insertion {
    struct insertion_options options;
    long done;  /* [-] spheres that came in */
    long tried; /* [-] places tried for the next one */
    /* What the options borrow, if it is to go with the source; else NULL. */
    struct sizes *own_sizes;
    struct insertion_one *own_list;
};

/* The diameter of sphere k of a source [m], and place number `attempt` [m]. */
double insertion_diameter(const struct insertion_options *o, long k);
void insertion_place(const struct insertion_options *o, long k, long attempt,
                     double d, double x[3]);

/* Adds to ps what is due at time t [s] and finds room in at most so many
 * attempts each; returns how many were added. What finds none waits. */
int insertion_step(struct insertion *in, struct particles *ps,
                   const struct domain *box, double t);

/* Whether two spheres of the list overlap by more than this share of their mean
 * diameter, so that they cannot come at once, and which. */
int insertion_clash(const struct insertion_options *o, const struct domain *box,
                    double share, int who[2]);

/* How many should have come by then [-]. */
long insertion_due(const struct insertion *in, double t);

/* The list in a file, "x y z d" a line, # for a remark; released with free().
 * NULL after a message that names the line. */
struct insertion_one *insertion_read(const char *path, long *n);

#endif
