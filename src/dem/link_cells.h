/* link_cells.h -- particles in cells, to find those that are near. Chapter
 * "Neighbours".
 *
 * The box is divided into cells that are at least as wide as the distance
 * looked for. A particle nearer than that to another one is in the same cell or
 * in one of those around it [LS section 5.2.2]. Each cell is a linked list.
 */
#ifndef DEM_LINK_CELLS_H
#define DEM_LINK_CELLS_H

#include "dem/box_domain.h"

enum { LINK_CELLS_AROUND = 27 };

struct link_cells {
    struct box_domain box;
    int cells[3];    /* [-] along x, y, z */
    double width[3]; /* [m] of a cell */
    int *head;       /* [-] a particle of each cell, or -1 */
    int *next;       /* [-] the next particle of its cell, or -1 */
    int capacity;    /* [-] particles */
};

struct link_cells *link_cells_create(int capacity,
                                     const struct box_domain *box);
void link_cells_free(struct link_cells *l);

/* Empties the cells and makes them at least `reach` wide [m]; 0: there is no
 * particle, and one cell. */
void link_cells_clear(struct link_cells *l, double reach);

/* Adds particle i at x [m]. */
void link_cells_add(struct link_cells *l, int i, const double x[3]);

/* The cells that contain every particle nearer to x than reach, each once;
 * returns their number. */
int link_cells_around(const struct link_cells *l, const double x[3],
                      int found[LINK_CELLS_AROUND]);

#endif
