/* manifest.h -- the list of the files that a run has put into its folder.
 *
 * A head line, then a name a line: "history.csv", "fluid/" for a folder in it,
 * "fluid/fluid_000000.vtr" for a file in that. A name is listed before its file
 * is made, so after any end the list holds everything that is there; some of it
 * may not be.
 */
#ifndef OUTPUT_MANIFEST_MANIFEST_H
#define OUTPUT_MANIFEST_MANIFEST_H

#include <stddef.h>

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

/* An open file with a closing zero, to be freed; NULL with a reason in errno.
 */
char *manifest_text(int file, size_t *length);

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

#endif
