/* case_file.h -- reads and checks a case. */
#ifndef CASE_CASE_FILE_H
#define CASE_CASE_FILE_H

#include "base/key.h"
#include "base/text.h"
#include "case/settings.h"

/* The keys of no group. How a table is searched and how a row is put into words
 * is in schema.h. */
extern const struct key case_file_keys[];

enum { CASE_FILE_TABLES = 128 }; /* at most, of the core and all models */

/* All tables of keys: the core and those of the models, ended by NULL. */
void case_file_tables(const struct key *tables[CASE_FILE_TABLES]);

/* How the path of a seed ends; 1 if this one does. */
#define CASE_FILE_SEED ".seed"
int case_file_is_seed(const char *path);

/* Adds the overrides that set all seeds of the case to so much more than they
 * are. */
void case_file_add_seeds(const struct settings *s, int more, struct texts *set);

/* Reads a case with its overrides and checks it, key by key and then as a
 * whole. NULL after one message; *code is then the exit code, 2 or 4. */
struct settings *case_file_read(const char *file, int n_overrides,
                                const char *const *overrides, int *code);

/* --- case steps: how a case divides its time.
 *
 * The steps of the loop are the fluid's, which the particles divide. Without a
 * fluid they are 20 particle steps where particles are inserted or removed,
 * for that happens between two steps of the loop; else the whole number of
 * particle steps that is nearest to the shorter of the times between two rows
 * of the history and two pictures. Thus the output does not change the motion.
 * Results are written after whole numbers of steps of the loop; `winnow check`
 * says where these are not what the case asks for. */

/* 0, or 2 after a message: a number of steps that cannot be counted, or a run
 * that ends before its first step does. */
int case_steps_check(const struct settings *s);

/* [s] of the loop. */
double case_steps_length(const struct settings *s);

/* The particle steps in one of the loop, at least 1: with a fluid as many as
 * make them no longer than the case asks; 0 without particles. */
int case_steps_within(const struct settings *s);

/* The steps of the loop until output.end. */
long case_steps_until_end(const struct settings *s);

/* The steps of the loop nearest to an interval [s], at least 1. */
long case_steps_between(const struct settings *s, double interval);

/* The steps of the loop between two rows of the history. */
long case_steps_between_rows(const struct settings *s);

#endif
