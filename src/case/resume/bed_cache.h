/* bed_cache.h -- large beds that were settled once.  Chapter "Nothing is lost".
 */
#ifndef CASE_RESUME_BED_CACHE_H
#define CASE_RESUME_BED_CACHE_H

#include "case/settings.h"
#include "dem/bed.h"

/* The bed of this case, if it is kept, is settled anew. */
void bed_cache_forget(const struct settings *s);

/* The path of the file that keeps a bed for which the case names none; 0: no
 * file, as without a folder that can be written, which is no error. */
int bed_cache_file(const struct settings *s, char *path, size_t room);

/* The bed from the file `path`, or made anew and kept there; NULL: it is not
 * kept. The file stays in `files`, if that is not NULL. `run` was created for
 * ps, which has no particles yet. Returns what bed_create does; BED_REFUSED
 * also if the file is of another bed, and BED_UNSAVED, after a message, if it
 * cannot be written. */
int bed_cache_create(struct inputs **files, const char *path,
                     struct particles *ps, struct dem *run,
                     const struct bed_options *bed,
                     const struct dem_options *dem, struct bed_report *r);

#endif
