/* motion_table.h -- a motion that is given by a table of times.
 * Chapter "Walls".
 *
 * A file has a column t [s], from 0 on, and places x, y, z [m] or velocities
 * v_x, v_y, v_z [m/s]; of either, those that are left out are 0. Both are
 * linear between rows. Only the way from the first place counts, so a motion
 * has no jump at its start. After its last row it rests, or it begins again
 * from where it then is.
 */
#ifndef DEM_SURFACES_MOTION_TABLE_H
#define DEM_SURFACES_MOTION_TABLE_H

#include "base/csv.h"

/* From the time t [s] since the start on, until that of the next row. */
struct motion_row {
    double t, x[3], v[3], a[3]; /* [s], [m], [m/s], [m/s^2] */
};

struct motion_table {
    int n;          /* [-] rows, 2 or more; the last one is at rest */
    int repeat;     /* [-] 1: after the last row it begins again */
    double fastest; /* [m/s] */
    struct motion_row row[];
};

/* As a case writes it. */
struct motion_course {
    const char *file;
    int repeat;                 /* [-] */
    struct motion_table *table; /* of the file */
};

/* To be released with free(); NULL after filling `wrong`. */
struct motion_table *motion_table_create(const struct input *in, int repeat,
                                         char wrong[CSV_WRONG]);

/* Adds its way [m] and its velocity [m/s] a time s [s] after the start. */
void motion_table_add(const struct motion_table *t, double s, double x[3],
                      double v[3]);

#endif
