/* bed_cache.h -- large beds that were settled once.  Chapter "Nothing is lost".
 */
#ifndef CASE_RESUME_BED_CACHE_H
#define CASE_RESUME_BED_CACHE_H

#include "case/settings.h"

/* The bed of this case, if it is kept, is settled anew. */
void bed_cache_forget(const struct settings *s);

#endif
