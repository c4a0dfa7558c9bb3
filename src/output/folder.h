/* folder.h -- the folder of a run.
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

/* Lists a name before its file is made, or a path that begins with DIR/;
 * non-zero after a message. */
int folder_add(struct folder *f, const char *name);
int folder_list(struct folder *f, const char *path);

/* A new table in the folder, or the table of a resumed run (table.h); NULL
 * after a message. The head is cleared. */
struct table *folder_table(struct folder *f, const char *name,
                           struct table_head *head);

/* The process whose run has locked the folder; 0 if there is none. */
long folder_process(const char *dir);

/* The path of the folder as the user gave it. */
const char *folder_name(const struct folder *f);

/* --- manifest: the list of the files that a run has put into its folder.
 *
 * A head line, then a name a line: "history.csv", "fluid/" for a folder in it,
 * "fluid/fluid_000000.vtr" for a file in that. A name is listed before its
 * file is made, so after any end the list holds everything that is there; some
 * of it may not be. */

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
