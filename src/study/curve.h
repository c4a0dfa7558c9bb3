/* curve.h -- what a study looks at in each run, and what that is compared with.
 *
 * A measure:
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
 *
 * A truth:
 *     0.0574, 0.05*(1-exp(-t/4e-4))
 *                     a formula; t, x, y, z are the first column
 *     XS11:4.1 u=0.05 d=8.3e-5 ...
 *                     an equation of `winnow eval`; an input t or x that is
 *                     left out is the first column
 *     measured.csv    the first two columns of a table, of which the first
 *                     rises; a row without a value is a gap, drawn across
 *     finest          the last entry of every choice
 *     extrapolated    Richardson's, along the axis, from the last three
 *                     entries; its order is told
 *     none            the measure is only listed
 */
#ifndef STUDY_CURVE_H
#define STUDY_CURVE_H

#include "case/settings.h"

/* What a measure finds in a run: points x with value and standard error, one
 * point of a number. */
struct curve {
    int n;
    double *x, *value, *error;
};
struct curve curve_create(int n);
void curve_free(struct curve *c);

/* The value at x, linear between points; that of a single point everywhere. nan
 * beyond the ends, and of a curve without points. *error, unless it is NULL, is
 * the standard error there. */
double curve_at(const struct curve *c, double x, double *error);

/* The mean of n > 0 curves at the points of the first. Its standard error is
 * the larger of two: from their scatter, and from their own errors. */
struct curve curve_mean(int n, const struct curve *of);

/* Of three curves, at the points of the last one: the size of the change from
 * the first to the second over that from the second to the third, sums of
 * squares under the roots; negative if the second goes the other way. nan if
 * the last change is no larger than chance explains, two standard errors. */
double curve_changes(const struct curve *a, const struct curve *b,
                     const struct curve *c);

/* The standard error of the mean of n independent samples; 0 of one. */
double curve_scatter(int n, const double *x);

/* Standard error of the mean of a time series. Its samples follow each other
 * too closely to be independent. Means of blocks of them are, once the blocks
 * are long enough: the standard error that follows from the scatter of the
 * blocks grows with their length up to the true one [Flyvbjerg89]. This is the
 * largest that blocks of 1, 2, 4, ... samples give, with at least 8 blocks; 0
 * for fewer than 8 samples. */
double curve_block_error(int n, const double *x);

/* The order p at which an error falls from one size h to a smaller one. */
double curve_order(double h_coarse, double e_coarse, double h_fine,
                   double e_fine);

/* Richardson's extrapolation: of a value q(h) = q_0 + C h^p at three sizes that
 * get smaller, the order p from the ratio of the two changes, |q_2 - q_1| /
 * |q_3 - q_2|. nan if no p from 0.1 to 12 fits. */
double curve_richardson(const double h[3], double ratio);

enum { MEASURE_NAME = 128 };

struct measure {
    enum measure_how {
        MEASURE_LAST,
        MEASURE_MEAN,
        MEASURE_MAX,
        MEASURE_MIN,
        MEASURE_CURVE
    } how;
    char text[MEASURE_NAME]; /* as it was given */
    char file[MEASURE_NAME]; /* of the run's folder */
    char name[MEASURE_NAME]; /* of the column, or path in the summary */
    char field[16];          /* of a probe or a profile; "" of others */
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

/* Its unit as the table of a run has it, "[m/s]"; "" where there is none. */
void measure_unit(const struct measure *m, const char *folder, char unit[16]);

/* A table as a run writes it: rows side by side, value[n_columns * row +
 * column], each column's name with its unit: "pressure_drop [Pa]". */
struct measure_table {
    int n_columns, n_rows;
    char **name;
    double *value;
};

/* A head and rows of as many numbers; lines that begin with # and empty ones
 * are left out, and an empty field is nan. NULL, without a message, if there is
 * no such table; *wrong is then the line that is no row, 0 if there are no
 * rows, -1 if there is no such file. If `wrong` is NULL the table is that of a
 * run, and a last line without an end was cut, and is left out. */
struct measure_table *measure_table_read(const char *path, int *wrong);
void measure_table_free(struct measure_table *t);

struct truth {
    enum truth_kind {
        TRUTH_FORMULA,
        TRUTH_EQUATION,
        TRUTH_TABLE,
        TRUTH_FINEST,
        TRUTH_EXTRAPOLATED,
        TRUTH_NONE
    } kind;
    char *text; /* as it was given */
    struct formula *formula;
    struct truth_equation *equation;
    struct curve table;
};

/* 0; or after a message 2 for a text that is none of these, 4 for a table that
 * cannot be read. */
int truth_parse(struct truth *t, const char *text);
void truth_free(struct truth *t);

/* 1 if a text is the name of a table. */
int truth_is_table(const char *text);

/* Of a formula, an equation or a table; nan where a table has nothing. */
double truth_value(const struct truth *t, double x);

#endif
