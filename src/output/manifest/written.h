/* written.h -- which files a run writes, by name and by content. */
#ifndef OUTPUT_MANIFEST_WRITTEN_H
#define OUTPUT_MANIFEST_WRITTEN_H

/* The folder itself, ".", and those in it; ended by NULL. */
extern const char *const written_folders[];

/* 1 for "fluid/" and the like. */
int written_folder(const char *name);

/* 1 for "history.csv.partial": half of a file, of which a link is none. */
int written_is_half(const char *name);

/* What stands at the start of a file of that name, or of half of it, "" if
 * anything may; NULL if no run writes one. */
const char *written_contents(const char *name);

/* 1 if a run writes such a file into the open folder, and none is there, or an
 * empty one, or one that begins so. Follows no link. */
int written_by_run(int here, const char *name);

#endif
