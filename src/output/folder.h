/* folder.h -- the folder of a run, which belongs to it alone.
 *
 * A run takes its folder by a lock on DIR/manifest.txt, which the system
 * releases however the run ends: a second run is refused, a dead one holds
 * nothing. The manifest lists every file before it is made. The next run
 * removes what is listed there and nothing else, so all that a run writes
 * stands beside files of the same run or of the user.
 *
 *     struct folder *f = folder_take("out/bed");   before the work
 *     if (folder_begin(f) != 0) ...                before the first file
 *     char *path = folder_file(f, "history.csv");  before each file
 *     folder_free(f);
 */
#ifndef FOLDER_H
#define FOLDER_H

#include "output/table.h"

struct folder;

/* Makes the folder and takes it; what is in it stays as it is. NULL after a
 * message: it cannot be written, another run has it, its manifest is not ours,
 * or a file has a name that the run may want and no run has listed. */
struct folder *folder_take(const char *dir);

/* Releases the folder. */
void folder_free(struct folder *f);

/* Takes back what folder_take made, if nothing was begun. The folder is still
 * to be freed. */
void folder_leave(struct folder *f);

/* Removes what the run before has left, and says so on stderr. Non-zero after a
 * message. */
int folder_begin(struct folder *f);

/* The path DIR/NAME of a file to be made, which is listed from now on; a new
 * string. NULL after a message. */
char *folder_file(struct folder *f, const char *name);

/* Makes the folder DIR/NAME for files of the run; non-zero after a message. */
int folder_make(struct folder *f, const char *name);

/* The same as folder_file for a path that begins with DIR/; non-zero after a
 * message. */
int folder_list(struct folder *f, const char *path);

/* A new table in it (table.h); NULL after a message. */
struct table *folder_table(struct folder *f, const char *name, int n_columns,
                           const char *const *columns);

/* The folder as the user calls it. */
const char *folder_name(const struct folder *f);

#endif
