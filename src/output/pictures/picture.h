/* picture.h -- a picture of the bed, drawn by gnuplot.
 *
 * DIR/bed.png shows, at one scale, the particles coloured by speed and the void
 * fraction averaged over the depth, both with the way up upwards and as seen
 * along z (along y, where z leads upwards), and beside them the
 * pressure drop in time with the weight of the bed. gnuplot does not read VTK,
 * so its data are written to DIR/picture: particles.txt, void_fraction.txt, and
 * bed.gp, which may be changed and run again:
 *
 *     cd DIR/picture && gnuplot bed.gp
 *
 * The pressure is read from DIR/history.csv, columns `time [s]`, `pressure_drop
 * [Pa]` and `buoyant_weight [Pa]`.
 */
#ifndef OUTPUT_PICTURES_PICTURE_H
#define OUTPUT_PICTURES_PICTURE_H

#include <stdio.h>

#include "dem/surfaces/surface.h"
#include "mesh/mesh.h"
#include "output/folder.h"

struct file;

/* The data of a picture; all borrowed. */
struct picture {
    const char *title;
    double time;      /* [s] */
    const double *up; /* [-] upwards, 3 */
    const struct mesh *mesh;
    const double *eps;   /* [-] void fraction a cell; NULL: no such panel */
    int n;               /* [-] particles; 0 allowed */
    const double *x[3];  /* [m] */
    const double *v[3];  /* [m/s] */
    const double *d;     /* [m] */
    int pressure;        /* [-] 1: history.csv has the columns above */
    const double *u, *p; /* [m/s], [Pa] of the cells; NULL: no fluid */
    int walls;           /* [-] 1: picture/walls.txt has segments x y [m] */
};

/* The axes to the right, up and of the depth. */
struct picture_view {
    int axis[3];
    double nearer; /* [-] 1: what is further along the depth is nearer; or -1 */
};
struct picture_view picture_view(const double up[3]);

/* Parts of a picture that an animation has as well.
 *
 * A file of the folder; NULL after a message. */
struct file *picture_open(struct folder *folder, const char *name);

/* Writes x, y, radius [m] and speed [m/s] of the particles, the farthest first;
 * non-zero after a message. */
int picture_write_particles(struct folder *folder, const char *name,
                            const struct picture *p);

/* The speed that 99 of 100 particles keep below [m/s]; 0 without any. */
double picture_speed_scale(const struct picture *p);

/* Title, time, box along the axes to the right and up, and `fast` [m/s], the
 * end of the colour scale, as gnuplot's variables. */
void picture_put_box(FILE *out, const struct picture *p, const int axis[2],
                     double fast);
void picture_put_number(FILE *out, const char *name, double value,
                        const char *unit);
void picture_put_row(FILE *out, int n, const double *row);

/* The programs for gnuplot, line by line, ended by NULL: NAME.gp with page.gp
 * where it is loaded. They follow the numbers that they use. */
extern const char *const picture_bed[],
    *const picture_flow[], *const picture_frames[], *const picture_study[];
void picture_put_program(FILE *out, const char *const *program);

/* Files and program of a flow without particles, with the names of the others;
 * non-zero after a message (slice.c). */
int picture_flow_write(struct folder *folder, const struct picture *p);

/* Writes the three files; non-zero after a message. */
int picture_write(struct folder *folder, const struct picture *p);

/* Lets gnuplot draw DIR/PNG by DIR/BELOW/bed.gp; the file appears when it is
 * complete. If gnuplot is missing or fails, a message says what to do, *drawn
 * is 0, and the run is complete all the same. Non-zero after a message. */
int picture_draw(struct folder *folder, const char *below, const char *png,
                 int *drawn);

/* --- slice: a plane through the middle of a mesh, as a grid of points.
 *
 * The plane is normal to the direction in which there is least to see: one
 * with a single cell, else the shortest. Its axes are x and y where that is z,
 * or the way up is one of them, upwards. */

struct slice {
    int axis[2];           /* [-] the directions to the right and up */
    int n[2];              /* [-] points along each */
    double lo[2], step[2]; /* [m] the first point, and between two */
    double *u, *v, *speed; /* [m/s] in the plane, and of all components */
    double *p;             /* [Pa] */
    unsigned char *inside; /* [-] 1 where there is a cell; else all are 0 */
};

/* Of cell values u (3 a cell) and p, with so many points, about. */
struct slice slice_of(const struct mesh *m, const double *u, const double *p,
                      const double up[3], int points);
void slice_release(struct slice *s);

/* The velocity in the plane at a place of it, linear between the points; 0 if
 * one of those is outside. Returns 1 if it is inside. */
int slice_velocity(const struct slice *s, const double x[2], double w[2]);

/* Lines along the velocity, evenly spread: for each point calls put(of, x), and
 * after each line put(of, NULL). `apart` [m] is their distance, about. */
void slice_streamlines(const struct slice *s, double apart,
                       void (*put)(void *of, const double *x), void *of);

/* --- outline: surfaces as polygons for display.
 *
 * A plane is drawn within the box, a cylinder as 64 flat sides as long as the
 * box, triangles as they are, any other shape as a net of its points. */

struct outline {
    int n_points, n_polygons, point_room, polygon_room;
    double *x;   /* [m] 3 a point */
    int *corner; /* [-] 0, 1, ...: polygons have no points in common */
    int *end;    /* [-] number of points up to the end of each polygon */
    int *of;     /* [-] the number of its surface */
};

void outline_release(struct outline *o);

/* Replaces the contents of o by all surfaces at time t [s]. */
void outline_draw(struct outline *o, const struct surface *list, int n,
                  const double lo[3], const double hi[3], double t);

/* Writes a segment, its places along the first two axes, for each polygon that
 * crosses the plane at z [m] along the third, each followed by an empty line,
 * with a number's shortest text. */
void outline_section(FILE *out, const struct outline *o, const int axis[3],
                     double z);

/* --- gnuplot: runs a script of it.
 *
 * gnuplot takes "<name" and "|name" for commands to be run by a shell,
 * wherever it expects the name of a file. So no name that a user has chosen is
 * passed to it: it runs within the folder, with names chosen here. */

/* The first line of the log, by which it is known. */
#define GNUPLOT_SAYS "What gnuplot says:\n"

/* Runs `gnuplot -c SCRIPT ABOVE FILE` in the folder, by plain names, ABOVE
 * being that of DIR; what it says goes to gnuplot.log, and FILE is renamed to
 * PNG when it is complete. Non-zero after a message that says what to do, also
 * if gnuplot is not installed. */
int gnuplot_draw(const char *folder, const char *script, const char *above,
                 const char *png);

#endif
