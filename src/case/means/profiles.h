/* profiles.h -- the profiles that a case asks for. */
#ifndef CASE_PROFILES_H
#define CASE_PROFILES_H

#include "output/folder.h"
#include "output/summary.h"
#include "case/settings.h"
#include "case/snapshot.h"

struct profiles;

enum { PROFILES_NAME = 64 };

/* What the file of the i-th profile is called, without its ending: "eps_f" at
 * 0.0164 m is "eps_f_y16.4mm"; a later one of the same field and height has the
 * beginning of its average besides, "_from1s". */
void profiles_name(const struct settings *s, int i, char name[PROFILES_NAME]);

/* One profile for each group of output.profiles; NULL after a message. The
 * snapshot is what they read. */
struct profiles *profiles_create(const struct settings *s,
                                 const struct simulation *sim,
                                 const struct snapshot *snapshot);
void profiles_free(struct profiles *l);

/* Takes a sample of the snapshot, which stands for dt [s]. */
void profiles_add(struct profiles *l, double dt);

/* How far each can be trusted: its mirror error and its error by blocks
 * (output/profile.h), as a group "profiles". */
void profiles_summary(const struct profiles *l, struct summary *to);

/* The means so far (state.h). */
void profiles_state(struct profiles *l, struct state *s);

/* Writes DIR/profiles/...; non-zero after a message. */
int profiles_write(const struct profiles *l, struct folder *folder);

#endif
