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

/* The process whose run has locked the folder; 0 if there is none. */
long ownership_process(const char *dir);

#endif
