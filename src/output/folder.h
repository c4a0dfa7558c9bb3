/* folder.h -- the folder of a run.
 *
 *     struct folder *f = folder_take("out/bed");   before the work
 *     if (folder_begin(f) != 0) ...                before the first file
 *     char *path = folder_file(f, "history.csv");  before each file
 *     folder_free(f);
 *
 * Where there is an owner of folders (manifest/), the folder belongs to this
 * run alone, and of an earlier run it has nothing left.
 */
#ifndef OUTPUT_FOLDER_H
#define OUTPUT_FOLDER_H

#include "output/table.h"

struct folder;

/* How a folder is kept for one run: one descriptor, or none. What take returns
 * is given to the others; all but leave, resume and free return non-zero after
 * a message, and prepare is called before a file that is made before begin. */
struct folder_owner {
    void *(*take)(const char *dir);
    int (*prepare)(void *own);
    int (*begin)(void *own, int quiet);
    void (*resume)(void *own);
    int (*list)(void *own, const char *name); /* before the file is made */
    void (*state)(void *own, struct state *s);
    void (*leave)(void *own);
    void (*free)(void *own);
};
extern const struct folder_owner *const folder_owners[]; /* ended by NULL */

/* Makes the folder if needed; its contents stay as they are. NULL after a
 * message if it cannot be written, if another run has locked it, if its
 * manifest is from another program, or if an unlisted file has a name that the
 * run may write. */
struct folder *folder_take(const char *dir);

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
#define FOLDER_AHEAD "checkpoint.ahead"
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
