/* bed_file.h -- a settled bed as a file.
 * Chapter "Particles and contact".
 *
 * Text: what the bed was made with, line by line; then the particles and the
 * histories of their contacts in hexadecimal numbers, which read back to the
 * same bits; last the checksum of all before it. A file that was made with
 * other options is refused, and one of which any byte was changed.
 */
#ifndef DEM_POPULATION_BED_FILE_H
#define DEM_POPULATION_BED_FILE_H

#include "dem/bed.h"

/* The file is written completely or not at all; non-zero after a message. */
int bed_file_save(const char *path, const struct particles *ps,
                  const struct bed_histories *histories,
                  const struct bed_options *bed, const struct dem_options *dem);

/* Adds the bed to ps. BED_CREATED, BED_ABSENT if there is no such file, or
 * BED_REFUSED after a message. */
int bed_file_load(const char *path, struct particles *ps,
                  struct bed_histories *histories,
                  const struct bed_options *bed, const struct dem_options *dem);

#endif
