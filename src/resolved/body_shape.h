/* body_shape.h -- where the surface of a body is.
 * Chapter "Resolving the grains".
 *
 * All that the flow around a body needs of its shape is the distance s of a
 * point from the surface, negative inside.
 */
#ifndef RESOLVED_BODY_SHAPE_H
#define RESOLVED_BODY_SHAPE_H

/* A body of any shape, in a frame of its own.
 *
 * The frame has its origin in the centroid and turns with the body: with Q the
 * rotation of the body, a point at r from the centre is at y = Q^T r. */

struct body_ball {
    double at[3]; /* [m] centre */
    double R;     /* [m] 0: a point of a surface (shapes/contact_points.h) */
};

struct body_outline {
    /* Signed distance [m] of y from the surface, negative inside. */
    double (*distance)(const struct body_outline *o, const double y[3]);
    double volume;       /* [m^3] */
    double gyration[6];  /* [m^2] moments of inertia over the mass, about the
                            centroid: xx, xy, xz, yy, yz, zz */
    double principal[4]; /* [-] the frame in which they are diagonal, */
    double moments[3];   /* [m^2] and what they are there (base/rotation.h) */
    double half[3];      /* [m] of a box around the centroid that contains it */
    double centre[3];    /* [m] the centroid, where the shape was given */
    int n_balls;         /* [-] that touch others: the spheres that it consists
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

enum body_shape_kind { BODY_SPHERE, BODY_BOX, BODY_CYLINDER, BODY_OUTLINE };

struct body_shape {
    enum body_shape_kind kind;
    double half[3]; /* [m] sphere: radius; box: halves of its edges; cylinder:
                       radius and half of the length; outline: of its box */
    double axis[3]; /* [-] of a cylinder, of length 1 */
    struct body_outline *outline; /* borrowed, until it is added to bodies,
                                     which free it; NULL: none of those */
    double turn[3][3];            /* [-] Q of an outline */
    int between; /* [-] bit k: walls across axis k hold a free one upright */
};

struct body_shape body_shape_sphere(double diameter);
struct body_shape body_shape_box(const double size[3]);
/* The axis may have any length but 0. */
struct body_shape body_shape_cylinder(double diameter, double length,
                                      const double axis[3]);
/* 1 if the axis of a cylinder is axis k of the mesh, but for rounding. */
int body_shape_along(const struct body_shape *shape, int k);
/* Not turned yet. */
struct body_shape body_shape_outline(struct body_outline *outline);

/* Signed distance [m] of the point r [m], seen from the centre of the body. */
double body_shape_distance(const struct body_shape *shape, const double r[3]);

/* Its gradient, the outward normal [-] of the surface next to r. */
void body_shape_normal(const struct body_shape *shape, const double r[3],
                       double n[3]);

/* Half of the extent along each axis of the mesh [m]. */
void body_shape_extent(const struct body_shape *shape, double extent[3]);

double body_shape_volume(const struct body_shape *shape); /* [m^3] */

/* The smallest width [m]: of a clump, the diameter of its largest ball; of a
 * closed surface, body_outline.h. */
double body_shape_width(const struct body_shape *shape);

/* How many balls touch others, and ball k: its centre from that of the body, in
 * the frame of the box. Boxes and cylinders have none. */
int body_shape_balls(const struct body_shape *shape);
struct body_ball body_shape_ball(const struct body_shape *shape, int k);

#endif
