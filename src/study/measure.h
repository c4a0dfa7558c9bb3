/* measure.h -- what a study looks at in each run.
 *
 *     mean_fall_velocity            the last value in history.csv
 *     mean_height@0.4               the value at 0.4 s
 *     mean:pressure_drop@0.3..0.6   the mean over a time; left out: the second
 *                                   half of the run. Of the rows that were due:
 *                                   each stands for the same time
 *     max:max_overlap   min:...     the largest, the smallest
 *     curve:us_y                    the whole course, here of a probe's field
 *     probe.1   profile.0           probes and profiles by number, from 0
 *                                   (a profile with its standard errors)
 *     worst.overlap                 a number of summary.json
 *     surfaces.csv/NAME             a column of another table of the run
 */
#ifndef STUDY_MEASURE_H
#define STUDY_MEASURE_H

#include "case/settings.h"
#include "study/curve.h"

enum { MEASURE_NAME = 128 };

enum measure_how {
    MEASURE_LAST,
    MEASURE_MEAN,
    MEASURE_MAX,
    MEASURE_MIN,
    MEASURE_CURVE
};

struct measure {
    enum measure_how how;
    char text[MEASURE_NAME]; /* as it was given */
    char file[MEASURE_NAME]; /* of the run's folder */
    char name[MEASURE_NAME]; /* of the column, or path in the summary */
    int column;              /* of the table; -1: by name */
    double from, to;         /* [s] or [m] along the first column */
};

/* Takes a measure apart; the case says which probes and profiles there are. 0,
 * or 2 after a message. */
int measure_parse(struct measure *m, const char *text,
                  const struct settings *s);

/* Looks into the folder of a run. The curve has no points if the run has
 * nothing there; NULL arrays then. */
struct curve measure_take(const struct measure *m, const char *folder);

#endif
