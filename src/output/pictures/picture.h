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

#include "mesh/mesh.h"
#include "output/folder.h"

#include <stdio.h>

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

#endif
