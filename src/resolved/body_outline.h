/* body_outline.h -- a body of any shape, in a frame of its own.
 * Chapter "Resolving the grains".
 *
 * The frame has its origin in the centroid and turns with the body: with Q the
 * rotation of the body, a point at r from the centre is at y = Q^T r.
 */
#ifndef RESOLVED_BODY_OUTLINE_H
#define RESOLVED_BODY_OUTLINE_H

struct body_ball {
    double at[3]; /* [m] centre */
    double R;     /* [m] 0: a point of a surface (shapes/contact_points.h) */
};

struct body_outline {
    /* Signed distance [m] of y from the surface, negative inside. */
    double (*distance)(const struct body_outline *o, const double y[3]);
    void (*free)(struct body_outline *o);
    double volume;      /* [m^3] */
    double gyration[6]; /* [m^2] moments of inertia over the mass, about the
                           centroid: xx, xy, xz, yy, yz, zz */
    double half[3];     /* [m] of a box around the centroid that contains it */
    double centre[3];   /* [m] the centroid, where the shape was given */
    int n_balls;        /* [-] that touch others: the spheres that it consists
                           of, or points of its surface; 0: none */
    struct body_ball *ball;
    double width;    /* [m] smallest; of a closed surface, as thick as all but a
                        tenth of it (thickness.h); 0: it consists of balls */
    int flat;        /* [-] points in one plane, at most; 0: it has none */
    int n_triangles; /* [-] of its surface; 0: none */
    double (*corner)[3][3]; /* [m]; borrowed from the shape */
    int kept; /* [-] 1: of many bodies, and not freed with one of them */
};

/* Which numbers of a symmetric matrix its six are: xx, xy, xz, yy, yz, zz. */
extern const int body_outline_row[6], body_outline_column[6];

/* Volume, centroid and gyration from the integrals over the shape of 1, x, and
 * x x^T, where it was given [m^3, m^4, m^5]. */
void body_outline_set_moments(struct body_outline *o, double V,
                              const double first[3], const double second[6]);
void body_outline_free(struct body_outline *o); /* NULL or kept: nothing */

/* 1 if it reaches from wall to wall, L [m] apart, along axis k before it turns:
 * not even half of a cell of the width h [m] is left. */
int body_outline_spans(const struct body_outline *o, int k, double L, double h);

#endif
