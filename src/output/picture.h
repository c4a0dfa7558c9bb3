/* picture.h -- a picture of the bed, drawn by gnuplot.
 *
 * DIR/bed.png shows, at one scale, the particles coloured by speed and the void
 * fraction averaged over the depth, both as seen along z, and beside them the
 * pressure drop in time with the weight of the bed. gnuplot reads no VTK, so
 * what it needs is left in DIR/picture: particles.txt, void_fraction.txt, and
 * bed.gp, which may be changed and run again:
 *
 *     cd DIR/picture && gnuplot bed.gp
 *
 * The pressure is read from DIR/history.csv, columns `time [s]`, `pressure_drop
 * [Pa]` and `bed_weight [Pa]`.
 */
#ifndef PICTURE_H
#define PICTURE_H

#include "mesh/mesh.h"
#include "output/folder.h"

/* What is to be seen; all borrowed. */
struct picture {
    const char *title;
    double time; /* [s] */
    const struct mesh *mesh;
    const double *eps;  /* [-] void fraction a cell; NULL: no such panel */
    int n;              /* [-] particles; 0 allowed */
    const double *x[3]; /* [m] */
    const double *v[3]; /* [m/s] */
    const double *d;    /* [m] */
    int pressure;       /* [-] 1: history.csv has the columns above */
};

/* Writes the three files; non-zero after a message. */
int picture_write(struct folder *folder, const struct picture *p);

/* Lets gnuplot draw DIR/bed.png from them, which appears whole. Without gnuplot
 * or when it fails: a message that says what to do, and non-zero; a run that
 * got so far is done all the same. */
int picture_draw(struct folder *folder);

#endif
