/* case_file.h -- reads and checks a case. */
#ifndef CASE_CASE_FILE_H
#define CASE_CASE_FILE_H

#include "base/key.h"
#include "case/settings.h"

/* The keys of no group. How a table is searched and how a row is put into words
 * is in schema.h. */
extern const struct key case_file_keys[];

enum { CASE_FILE_TABLES = 128 }; /* at most, of the core and all models */

/* All tables of keys: the core and those of the models, ended by NULL. */
void case_file_tables(const struct key *tables[CASE_FILE_TABLES]);

/* Reads a case with its overrides and checks it, key by key and then as a
 * whole. NULL after one message; *code is then the exit code, 2 or 4. */
struct settings *case_file_read(const char *file, int n_overrides,
                                const char *const *overrides, int *code);

#endif
