/* manifest.h -- the list of the files that a run has put into its folder.
 *
 * A head line, then a name a line: "history.csv", "fluid/" for a folder in it,
 * "fluid/fluid_000000.vtr" for a file in that. A name is listed before its file
 * is made, so after any end the list holds everything that is there; some of it
 * may not be.
 */
#ifndef OUTPUT_MANIFEST_H
#define OUTPUT_MANIFEST_H

#define MANIFEST_HEAD "winnow manifest 1\n"

struct manifest {
    int n;
    char *text;  /* text of the whole list */
    char **name; /* ascending, within text */
};

/* Reads a list from an open file, called `path` in messages; an empty file is
 * an empty list. Non-zero after a message if a line is no name of a file in
 * this folder or in one just below: the list is then not from a run. */
int manifest_read(struct manifest *m, int file, const char *path);
void manifest_release(struct manifest *m);

int manifest_has(const struct manifest *m, const char *name);

/* Removes all that is listed below the open folder `here`, called `dir` in
 * messages, summary.json first; what is called NAME.partial, and folders that
 * are empty then, too. Follows no link. *removed counts files. Non-zero after a
 * message. */
int manifest_remove(const struct manifest *m, int here, const char *dir,
                    int *removed);

/* Removes what the open list of a folder has after its first `length` bytes,
 * and then those lines. Non-zero after a message; then also if the list is
 * shorter. */
int manifest_cut(int file, const char *path, long length, int here,
                 const char *dir);

/* --- which files a run writes, by name and by content --------------------- */

/* The folder itself, ".", and those in it; ended by NULL. */
extern const char *const manifest_folders[];

/* 1 for "fluid/" and the like. */
int manifest_is_folder(const char *name);

/* 1 for "history.csv.partial": half of a file, of which a link is none. */
int manifest_is_half(const char *name);

/* What stands at the start of a file of that name, or of half of it, "" if
 * anything may; NULL if no run writes one. */
const char *manifest_contents(const char *name);

/* 1 if a run writes such a file into the open folder, and none is there, or an
 * empty one, or one that begins so. Follows no link. */
int manifest_is_of_run(int here, const char *name);

#endif
