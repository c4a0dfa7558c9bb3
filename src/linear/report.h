/* report.h -- the report of an iterative solver.
 *
 * The caller reads it: a solver never aborts and never hides that it failed.
 */
#ifndef LINEAR_REPORT_H
#define LINEAR_REPORT_H

struct solve_report {
    int iterations;
    double before, after; /* [-] 2-norm of b - A x over its scale |b|_2, at
                             entry and at return */
    int converged;        /* 1: |b - A x| is not above what was asked for */
};

#endif
