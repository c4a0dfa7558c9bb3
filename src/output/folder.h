/* folder.h -- the folder of a run, which belongs to it alone.
 *
 * A run takes its folder by a lock on DIR/manifest.txt, which the system
 * releases however the run ends: a second run is refused, and a run that was
 * killed leaves no lock. The manifest lists every file before it is made. The
 * next run removes what is listed there and nothing else, so the files of a run
 * are mixed only with files of the user.
 *
 *     struct folder *f = folder_take("out/bed");   before the work
 *     if (folder_begin(f) != 0) ...                before the first file
 *     char *path = folder_file(f, "history.csv");  before each file
 *     folder_free(f);
 */
#ifndef OUTPUT_FOLDER_H
#define OUTPUT_FOLDER_H

#include "output/table.h"

struct folder;

/* Makes the folder if needed and locks it; its contents stay as they are. NULL
 * after a message if it cannot be written, if another run has locked it, if its
 * manifest is from another program, or if an unlisted file has a name that the
 * run may write. */
struct folder *folder_take(const char *dir);

/* The process whose run has locked the folder; 0 if there is none. */
long folder_process(const char *dir);

/* Releases the folder. */
void folder_free(struct folder *f);

/* Removes the folders that folder_take made, if nothing was begun and nothing
 * was made ahead. f must still be freed. */
void folder_leave(struct folder *f);

/* Lets folder_begin remove without a word. */
void folder_set_quiet(struct folder *f);

/* Removes the files of the previous run, with a message on stderr. Non-zero
 * after a message. */
int folder_begin(struct folder *f);

/* The path DIR/checkpoint.ahead of the one file that a run may make before
 * folder_begin, as a new string; no list has it. The folder stays, when it is
 * left, as long as the file is there. NULL after a message. */
char *folder_ahead(struct folder *f);

/* Instead of folder_begin, for a run that goes on: the files stay, and what is
 * in the manifest already is not added again, until the state is loaded. */
void folder_resume(struct folder *f);

/* The length of the manifest (state.h). When it is loaded, what was listed
 * later is removed. */
void folder_state(struct folder *f, struct state *s);

/* The path DIR/NAME of a file to be made, as a new string; adds the name to the
 * manifest. NULL after a message. */
char *folder_file(struct folder *f, const char *name);

/* Makes the folder DIR/NAME for files of the run; non-zero after a message. */
int folder_make(struct folder *f, const char *name);

/* The same as folder_file for a path that begins with DIR/; non-zero after a
 * message. */
int folder_list(struct folder *f, const char *path);

/* A new table in it, or that of a run that goes on (table.h); NULL after a
 * message. */
struct table *folder_table(struct folder *f, const char *name, int n_columns,
                           const char *const *columns);

/* The path of the folder as the user gave it. */
const char *folder_name(const struct folder *f);

#endif
