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
 * beyond the ends, and of a curve without points. */
double curve_at(const struct curve *c, double x);

/* Root of the sum of squared differences at the points of the second. */
double curve_difference(const struct curve *a, const struct curve *b);

#endif
