/* report.h -- what an iterative solver says about its work.
 *
 * The caller reads it: a solver never aborts and never hides that it failed.
 */
#ifndef REPORT_H
#define REPORT_H

struct solve_report {
    int iterations;
    double before, after; /* [-] 2-norm of b - A x over its scale |b|_2, at
                             entry and at return; both 0 if b = 0 */
    int converged;        /* 1: |b - A x| <= max(tolerance |b|, absolute) */
};

#endif
