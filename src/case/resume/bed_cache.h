/* bed_cache.h -- large beds that were settled once.  Chapter "Nothing is lost".
 */
#ifndef CASE_RESUME_BED_CACHE_H
#define CASE_RESUME_BED_CACHE_H

#include "case/settings.h"

/* The bed of this case, if it is kept, is settled anew. */
void bed_cache_forget(const struct settings *s);

/* The path of the file that keeps a bed for which the case names none; 0: no
 * file, as without a folder that can be written, which is no error. */
int bed_cache_file(const struct settings *s, char *path, size_t room);

#endif
