/* statistics_files.h -- the files of output.statistics. */
#ifndef RECORD_STATISTICS_FILES_H
#define RECORD_STATISTICS_FILES_H

#include "base/statistics/temperature.h"
#include "record/grain_series.h"
#include "record/layers.h"
#include "coupling/simulation.h"
#include "output/folder.h"

enum { STATISTICS_SCALARS = 5 };

struct case_statistics {
    const struct simulation *sim; /* borrowed */
    struct folder *folder;        /* borrowed */
    const char *const *names;     /* of the scalars */
    const char *const *columns;   /* of series.csv */
    int n_scalars;
    double from, plateau;  /* [s] */
    int blocks, lags;      /* [-] */
    int quiet;             /* [-] 1: nothing is said on stderr */
    double dt;             /* [s] between two samples */
    int axis;              /* 0, 1, 2: along gravity */
    int rows, n, first;    /* [-] room, rows so far, first one that counts */
    double *series;        /* rows of time and scalars */
    double *room;          /* 2 a particle */
    struct layers *layers; /* NULL without fluid */
    struct grain_series *grains; /* NULL unless asked for */
};

/* Non-zero after a message. */
int statistics_files_write(const struct case_statistics *self);

#endif
