/* output_options.h -- how long a case runs, and what it writes of the run. */
#ifndef OUTPUT_OUTPUT_OPTIONS_H
#define OUTPUT_OUTPUT_OPTIONS_H

#include "base/key.h"

/* A mean on a line. */
struct output_profile {
    const char *field, *along;  /* "u_y", "x" */
    double place[3];            /* [m] of the line in x, y, z */
    int has_place[3];           /* [-] 1 where the case gives it */
    double from;                /* [s] of the first sample */
    struct key_series measured; /* [m], in the unit of the field */
};

struct output_probe {
    const char *field;
    double position[3]; /* [m] */
};

/* The forces on some walls. */
struct output_force {
    const char *name, *patches, *surfaces; /* NULL: left out */
    double centre[3];                      /* [m] of the torque */
    double velocity, area, length;         /* [m/s], [m^2], [m]; 0: left out */
    double drag[3], lift[3], axis[3];      /* [-] directions of any length */
};

struct output_statistics {
    int on;                     /* [-] 1: the case has the group */
    double from, plateau, lags; /* [s]; lags 0: left out */
    int blocks;                 /* [-] */
};

struct output_options {
    double end, every; /* [s] of the run; between two pictures of the fields */
    double history;    /* [s] between two rows; 0: left out */
    double checkpoint; /* [s] of wall time */
    int picture, animation, report, contacts, walls, sorted; /* [-] 1: on */
    const char *format;    /* "vtk", or "vtu" for all files */
    const char *particles; /* further arrays, by their names; NULL: none */
    struct output_statistics statistics;
    struct {
        int n;
        struct output_profile *item;
    } profiles;
    struct {
        int n;
        struct output_probe *item;
    } probes;
    struct {
        int n;
        struct output_force *item;
    } forces;
};

/* The fields that profiles and probes are of, as a row allows them. */
#define FIELD_NAMES "eps_f | eps_s | p | u_x | u_y | u_z | us_x | us_y | us_z"

extern const struct key output_keys[];

#endif
