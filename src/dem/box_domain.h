/* box_domain.h -- the box of the particles.  Chapter "Particles and contact".
 *
 * It has six walls, or fewer where a direction is periodic. The numbers that a
 * direction with walls does not need are 0, so that the nearest image is the
 * same formula for both.
 */
#ifndef DEM_BOX_DOMAIN_H
#define DEM_BOX_DOMAIN_H

#include <math.h>

struct box_domain {
    double lo[3], hi[3]; /* [m] */
    int periodic[3];     /* [-] 1: hi and lo are the same place */
    double length[3];    /* [m] hi - lo if periodic, else 0 */
    double inverse[3];   /* [1/m] 1 / (hi - lo) if periodic, else 0 */
};

static inline struct box_domain
box_domain_of(const double lo[3], const double hi[3], const int periodic[3])
{
    struct box_domain box;

    for (int k = 0; k < 3; k++) {
        box.lo[k] = lo[k];
        box.hi[k] = hi[k];
        box.periodic[k] = periodic[k];
        box.length[k] = periodic[k] ? hi[k] - lo[k] : 0.0;
        box.inverse[k] = periodic[k] ? 1.0 / (hi[k] - lo[k]) : 0.0;
    }
    return box;
}

/* x in a periodic direction k, brought back between lo and hi; in others x. */
static inline double box_domain_inside(const struct box_domain *box, int k,
                                       double x)
{
    return x - box->length[k] * floor((x - box->lo[k]) * box->inverse[k]);
}

/* The difference dx [m] of two positions along k, to the nearest image. */
static inline double box_domain_nearest(const struct box_domain *box, int k,
                                        double dx)
{
    return dx - box->length[k] * rint(dx * box->inverse[k]);
}

/* Gap [m] from x to wall w, 2 k for the lower and 2 k + 1 for the upper one of
 * direction k; negative beyond it. */
static inline double box_domain_gap(const struct box_domain *box, int w,
                                    const double x[3])
{
    const int k = w / 2;
    return w % 2 ? box->hi[k] - x[k] : x[k] - box->lo[k];
}

/* --- link cells: particles in cells, to find those that are near. Chapter
 * "Neighbours".
 *
 * The box is divided into cells that are at least as wide as the distance
 * looked for. A particle nearer than that to another one is in the same cell
 * or in one of those around it [LS section 5.2.2]. Each cell is a linked list.
 */

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

/* How a box of these lengths [m] is divided into cells at least `reach` wide
 * [m], of which there are not many more than particles fit in. */
void link_cells_divide(const double length[3], double reach, int capacity,
                       int cells[3]);

/* Of m cells along a direction those before, at and after number `at`, each
 * once: with two round a period, the one before is the one after. Returns how
 * many. */
int link_cells_beside(int m, int periodic, int at, int found[3]);

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
