/* case_sizes.h -- distributions of diameters and the file of a bed, out of the
 * settings. */
#ifndef CASE_POPULATION_CASE_SIZES_H
#define CASE_POPULATION_CASE_SIZES_H

#include "dem/population/sizes.h"
#include "case/settings.h"

/* Are the distributions of the case possible, and their names its own? 0, or 2
 * after a message. */
int case_sizes_check(const struct settings *s);

/* Is there one of the name that the key has? 0, or 2 after a message. */
int case_sizes_check_name(const struct settings *s, const char *key,
                          const char *name);

/* A bed that is not there yet will be written, and no case writes beyond its
 * own folder: is it in there? 0, or 2 after a message. */
int case_sizes_check_file(const struct settings *s);

/* The distribution of that name, which is there. */
struct sizes *case_sizes_create(const struct settings *s, const char *name);

#endif
