/* profiles.h -- how what a case asks for is called in the files. */
#ifndef RECORD_PROFILES_H
#define RECORD_PROFILES_H

#include "output/means/profile.h"
#include "output/output_options.h"

/* Where the line of a profile is; `across` is -1 where the case does not say
 * it. */
struct profile_line profiles_line(const struct output_profile *p);

/* What the file of the i-th profile is called, without its ending: "eps_f" at
 * the height of 0.0164 m is "eps_f_y16.4mm", along y at x = 0.011 m it is
 * "eps_f_along_y_x11mm"; a later one of the same field and line has the
 * beginning of its average besides, "_from1s". */
enum { PROFILES_NAME = 64 };
void profiles_name(const struct output_options *o, int i,
                   char name[PROFILES_NAME]);

/* How the columns of one begin in forces.csv: its name, or its patches or
 * surfaces, of which the first letters are taken if there are many. */
void recorder_forces_name(const struct output_force *o,
                          char name[PROFILES_NAME]);

#endif
