/* motion.h -- the prescribed motion of a wall or a particle.
 * Chapter "Walls".
 *
 *   c(t) = c_0 + v s + A sin(2 pi f s),   s = t - from, not beyond until
 *   x(t) = c(t) + Q(omega s) (x_0 - c_0)                              (14.6)
 *
 * a rigid motion: the sum of a velocity, an oscillation and a rotation about an
 * axis through c; and of the way of a table, if there is one. The position of a
 * point is a function of time, so errors do not accumulate from step to step.
 */
#ifndef DEM_SURFACES_MOTION_H
#define DEM_SURFACES_MOTION_H

#include "base/csv.h"

/* --- motion table: a motion that is given by a table of times.
 *
 * A file has a column t [s], from 0 on, and places x, y, z [m] or velocities
 * v_x, v_y, v_z [m/s]; of either, those that are left out are 0. Both are
 * linear between rows. Only the way from the first place counts, so a motion
 * has no jump at its start. After its last row it rests, or it begins again
 * from where it then is. */

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

/* --- motion --------------------------------------------------------------- */

/* A rigid body at one moment. */
struct pose {
    double start[3];       /* [m] c_0 */
    double centre[3];      /* [m] c(t) */
    double rotation[3][3]; /* [-] Q */
    double velocity[3];    /* [m/s] dc/dt */
    double spin[3];        /* [rad/s] */
};

/* A body whose motion is computed elsewhere while the particles move: its pose
 * at time t, from which it goes on with its velocity. */
struct carrier {
    struct pose pose;
    double t; /* [s] */
};

/* A wall without mass that moves along the force that it is to exert, at most
 * at a speed (surfaces_follow_loads). */
struct motion_load {
    double force[3];         /* [N] W */
    double speed;            /* [m/s] 0: there is none */
    struct carrier *carrier; /* that of the motion; it belongs to the case */
};

struct motion {
    const struct carrier *carrier; /* borrowed; NULL: as the following say */
    double from, until;  /* [s] at rest before and after; until 0: no end */
    double velocity[3];  /* [m/s] v */
    double amplitude[3]; /* [m] A */
    double frequency;    /* [Hz] f */
    double centre[3];    /* [m] c_0, a point of the axis at time `from` */
    double spin[3];      /* [rad/s] omega */
    const struct motion_table *table; /* borrowed; NULL: none */
};

struct pose motion_pose(const struct motion *m, double t);

/* 1 if it ever moves; 1 if t is within its times, also where all velocities are
 * 0: a prescribed particle is then held. */
int motion_is_any(const struct motion *m);
int motion_is_on(const struct motion *m, double t);

/* No point within `reach` [m] of c is ever faster [m/s]. */
double motion_speed(const struct motion *m, double reach);

/* Maps the initial position of a point to the present one, and back.
 * motion_turn only rotates a vector. */
void motion_place(const struct pose *p, const double start[3], double x[3]);
void motion_origin(const struct pose *p, const double x[3], double start[3]);
void motion_turn(const struct pose *p, const double start[3], double v[3]);

/* Velocity of the body at x: dc/dt + omega x (x - c) [m/s]. */
void motion_velocity(const struct pose *p, const double x[3], double v[3]);

#endif
