/* state_file.h -- a state as an HDF5 file.  Chapter "Nothing is lost".
 *
 * Each visited array is a dataset under the path of its part, "/fluid/p", with
 * its unit and a checksum as attributes; texts about the run stand beside them.
 * `h5dump` and every library for HDF5 read it. The file is made in
 * memory, so that a full disk or a signal meets no half-written HDF5; it ends
 * with a line that has the checksum of all before it.
 */
#ifndef OUTPUT_CHECKPOINT_STATE_FILE_H
#define OUTPUT_CHECKPOINT_STATE_FILE_H

#include "base/state.h"
#include "base/file.h"

struct state_file;

/* The bytes of a file, released with free(); NULL after a message. */
struct state_image {
    unsigned char *bytes;
    size_t size;
};

/* An empty file, in memory. */
struct state_file *state_file_create(void);
void state_file_free(struct state_file *f);

/* The visitor that saves or loads; borrowed. */
struct state *state_file_state(struct state_file *f);

void state_file_put_text(struct state_file *f, const char *name,
                         const char *text);

/* The bytes of the file; f is released. */
struct state_image state_file_image(struct state_file *f);

/* Writes the file to PATH.partial, flushes and renames it; an older PATH is
 * then called `before`, if that is not NULL. At any moment there is a whole
 * one. Non-zero after a message. */
int state_file_write(const struct state_image *image, const char *path,
                     const char *before);

/* A file that was written, all of it read and its checksum verified. NULL, with
 * the reason in words in `why`; then why is NULL if there is no such file. */
struct state_file *state_file_open(const char *path, const char **why);
struct state_file *state_file_of(const struct input *in, const char **why);

/* A text as a new string, "" if the file has none of that name. */
char *state_file_text(struct state_file *f, const char *name);

/* A single number "/t", which is not counted as visited; nan if there is none.
 */
double state_file_number(struct state_file *f, const char *path);

/* Non-zero after a message if the file has arrays that were not visited. */
int state_file_all_visited(const struct state_file *f);

#endif
