/* layers.h -- the fluid fraction of horizontal layers of cells, in time.
 * Chapter "Agitation". */
#ifndef RECORD_LAYERS_H
#define RECORD_LAYERS_H

#include "base/state.h"
#include "mesh/mesh.h"

struct layers {
    int n;            /* [-] layers */
    int rows, n_rows; /* [-] room, samples so far */
    int *layer;       /* [-] of each cell */
    double *height;   /* [m] of the middle of each */
    double *volume;   /* [m^3] of its cells */
    double *eps;      /* [-] rows * n */
    int cells;
    const double *V; /* [m^3] of the cells, borrowed */
};

/* Cells whose centres have the same coordinate along an axis are a layer; in a
 * mesh without layers, as many equal slices as the box has cells on an edge. */
struct layers *layers_create(const struct mesh *m, int axis, int rows);
void layers_free(struct layers *l);

/* A sample of the field eps of the cells. */
void layers_add(struct layers *l, const double *eps);
void layers_state(struct layers *l, struct state *s);

#endif
