/* curve.h -- what a measure finds in a run: points x with value and standard
 * error, one point of a number. */
#ifndef STUDY_CURVE_H
#define STUDY_CURVE_H

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

#endif
