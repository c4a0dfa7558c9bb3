/* lines.h -- the profiles that a case asks for. */
#ifndef LINES_H
#define LINES_H

#include "output/folder.h"
#include "scene/settings.h"
#include "scene/snapshot.h"

struct lines;

enum { LINES_NAME = 64 };

/* What the file of the i-th profile is called, without its ending: "eps_f" at
 * 0.0164 m is "eps_f_y16.4mm"; a later one of the same field and height has the
 * beginning of its average besides, "_from1s". */
void lines_name(const struct settings *s, int i, char name[LINES_NAME]);

/* One profile for each group of output.profiles; NULL after a message. The
 * snapshot is what they look at. */
struct lines *lines_create(const struct settings *s,
                           const struct simulation *sim,
                           const struct snapshot *look);
void lines_free(struct lines *l);

/* Takes a sample of the snapshot, which stands for dt [s]. */
void lines_add(struct lines *l, double dt);

/* Writes DIR/profiles/...; non-zero after a message. */
int lines_write(const struct lines *l, struct folder *folder);

#endif
