/* recorder_internal.h -- what the files behind recorder.h share. */
#ifndef RECORD_RECORDER_INTERNAL_H
#define RECORD_RECORDER_INTERNAL_H

#include "record/field_output.h"
#include "record/history.h"
#include "record/recorder.h"
#include "record/recorder_part.h"
#include "output/table.h"

enum { MAX_COLUMNS = 128 };

struct recorder {
    const struct settings *settings;
    const struct simulation *sim;
    const struct simulation *drawn; /* what pictures show: all processes */
    struct folder *folder;          /* borrowed */
    double began;                   /* [s] wall clock */
    double ended;                   /* [s] the same; 0 while the run goes on */
    int n_columns; /* [-] of the table; those of effects follow the others */
    int n_own;     /* [-] the others */
    const struct history_column *column[MAX_COLUMNS];
    struct table *history;
    struct snapshot *snapshot;
    struct snapshot *whole; /* of what is drawn; the same on one machine */
    struct field_output *pictures;
    struct recorder_part_list parts; /* what folders add */
    long row_every, picture_every;   /* [-] steps of the loop */
    /* For the summary: the worst of the whole run. */
    double worst_mass, worst_momentum, worst_exchange, worst_overlap, worst_cfl;
    double eps_lowest;
    long capped_steps;
};

/* Takes the snapshots. */
void recorder_take_snapshots(struct recorder *r);

#endif
