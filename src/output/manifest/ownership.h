/* ownership.h -- a folder that belongs to one run alone.
 *
 * A run takes its folder by a lock on DIR/manifest.txt, which the system
 * releases however the run ends: a second run is refused, and a run that was
 * killed leaves no lock. The manifest lists every file before it is made. The
 * next run removes what is listed there and nothing else, so the files of a run
 * are mixed only with files of the user.
 */
#ifndef OUTPUT_MANIFEST_OWNERSHIP_H
#define OUTPUT_MANIFEST_OWNERSHIP_H

#include "base/state.h"

struct ownership;

/* NULL after a message. */
struct ownership *ownership_take(const char *dir);
void ownership_free(struct ownership *f);

/* 1 if it has files of an earlier run. */
int ownership_is_used(const struct ownership *f);

/* These return non-zero after a message: before a file that begin must keep;
 * before the first file of a new run, whose predecessor's files are removed;
 * and before any file is made. */
int ownership_prepare(struct ownership *f);
int ownership_begin(struct ownership *f);
int ownership_list(struct ownership *f, const char *name);

void ownership_resume(struct ownership *f); /* instead of begin */
void ownership_leave(struct ownership *f);  /* of a run that did not begin */
void ownership_state(struct ownership *f, struct state *s);

/* The process whose run has locked the folder; 0 if there is none. */
long ownership_process(const char *dir);

#endif
