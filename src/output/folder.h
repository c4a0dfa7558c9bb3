/* folder.h -- the folder of a run.
 *
 *     struct folder *f = folder_open("out/bed");   before the work
 *     if (folder_begin(f) != 0) ...         before the first file
 *     char *path = folder_file(f, "history.csv");  before each file
 *     folder_free(f);
 *
 * A run takes its folder by a lock on DIR/manifest.txt, which the system
 * releases however the run ends: a second run is refused, and a run that was
 * killed leaves no lock. The manifest lists every file before it is made. The
 * next run removes what is listed there and nothing else, so the files of a run
 * are mixed only with files of the user.
 */
#ifndef OUTPUT_FOLDER_H
#define OUTPUT_FOLDER_H

#include "output/table.h"

struct folder;

/* Makes the folder if needed; its contents stay as they are. NULL after a
 * message if it cannot be written, if another run has locked it, if its
 * manifest is from another program, or if an unlisted file has a name that the
 * run may write. */
struct folder *folder_open(const char *dir);

/* Releases the folder. */
void folder_free(struct folder *f);

/* Removes the folders that folder_open made, unless folder_begin was called or
 * a file was made before it. f must still be freed. */
void folder_abandon(struct folder *f);

/* Removes the files of the previous run. Non-zero after a message. */
int folder_begin(struct folder *f);

/* 1 if files of an earlier run are there, which folder_begin will remove. */
int folder_is_used(const struct folder *f);

/* The path of the one file that a run may make before folder_begin, as a new
 * string. It is not listed, and while it exists folder_abandon removes nothing.
 * NULL after a message. */
#define FOLDER_EARLY_FILE "checkpoint.ahead"
char *folder_early_file(struct folder *f);

/* In place of folder_begin, for a run that is resumed: the files stay, and
 * listed files are not listed again, until the state is loaded. */
void folder_resume(struct folder *f);

/* Visits the list of files (state.h): when it is loaded, files that were listed
 * later are removed. */
void folder_state(struct folder *f, struct state *s);

/* Lists a file to be made; its path DIR/NAME is a new string. NULL after a
 * message. */
char *folder_file(struct folder *f, const char *name);

/* Makes the folder DIR/NAME for files of the run; non-zero after a message. */
int folder_make(struct folder *f, const char *name);

/* Lists a path that begins with DIR/; non-zero after a message. */
int folder_list(struct folder *f, const char *path);

/* A new table in the folder, or the table of a resumed run (table.h); NULL
 * after a message. The head is cleared. */
struct table *folder_table(struct folder *f, const char *name,
                           struct table_head *head);

/* The process whose run has locked the folder; 0 if there is none. */
long folder_process(const char *dir);

/* The path of the folder as the user gave it. */
const char *folder_name(const struct folder *f);

#endif
