/* crossing.h -- two spheres that are past each other before they have met.
 * Chapter "Time steps".
 *
 * A contact is found at the places after a step. Where a sphere moves by more
 * than its radius in one, it can be beyond another one by then, and no force
 * ever says so: the pair has crossed.
 */
#ifndef DEM_CROSSING_H
#define DEM_CROSSING_H

struct dem_crossing {
    int found; /* [-] 1: two have crossed */
    int id[2]; /* [-] these */
};

/* 1 if two whose centres are apart by x now [m], and moved by `way` against
 * each other in the step [m], passed each other within `reach` [m]: the line of
 * centres has turned round, and was shorter than that in between. */
static inline int crossing(const double x[3], const double way[3], double reach)
{
    double old2 = 0.0, along = 0.0, way2 = 0.0, turned = 0.0;

    for (int k = 0; k < 3; k++) {
        const double old = x[k] - way[k];
        old2 += old * old;
        along += old * way[k];
        way2 += way[k] * way[k];
        turned += old * x[k];
    }
    return turned < 0.0 && old2 - along * along / way2 < reach * reach;
}

#endif
