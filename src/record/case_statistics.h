/* case_statistics.h -- output.statistics: means and correlations of a bed.
 * Chapter "Agitation".
 *
 * From the time `from` on each row of history.csv is a sample. Written into
 * DIR/statistics/ at the end:
 *
 *   series.csv       granular temperature along gravity and across it, heights,
 *                    and with a fluid the pressure drop, all from the start
 *   profile.csv      fluid fraction against height, with its error
 *   correlation.csv  R of the grains' drag coefficients, its running integral
 *   density.csv      their density, and that of one over its mean
 *   summary.json     mean, standard error by blocks, deviation, skewness, and
 *                    integral time of each
 */
#ifndef RECORD_CASE_STATISTICS_H
#define RECORD_CASE_STATISTICS_H

#include "record/recorder_part.h"

extern const struct key case_statistics_keys[];

/* Prints its lines for `winnow check`. */
void case_statistics_print(const struct settings *s);

extern const struct recorder_part case_statistics_output;

#endif
