/* study_report.h -- what a study writes and says.
 *
 *     study.csv    a row a run: its choices, processor seconds in all and wall
 *                  seconds by part, steps, memory, each measure with its truth,
 *                  its error and the standard error of that
 *     study.md     a row a variant, orders, and the advice
 *     study.svg, study.png, study.gp
 *                  error against cost, the script with its data
 */
#ifndef STUDY_STUDY_REPORT_H
#define STUDY_STUDY_REPORT_H

#include "study/outcome.h"

#include <stdio.h>

/* Non-zero after a message if a file could not be written; a picture that could
 * not be drawn, for want of gnuplot, is told and nothing else. */
int study_report_runs(const struct outcomes *o);
int study_report_variants(const struct outcomes *o);
int study_report_picture(const struct outcomes *o);

/* A file in the folder of the study, to be committed; NULL after a message. */
struct file *study_report_file(const struct plan *p, const char *name);

/* Which variant is the cheapest within 5 %, 1 %, 0.1 % of the truth, and what
 * the case as it stands costs beside it. */
void study_report_advice(const struct outcomes *o, FILE *out);

#endif
