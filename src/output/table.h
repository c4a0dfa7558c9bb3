/* table.h -- tables as CSV: a head line, then rows of numbers.
 *
 * The head names each column with its unit, "pressure_drop [Pa]". A history
 * grows by a row at a time; each row is written completely or not at all, so
 * the file can be read during the run and is valid however the run ends.
 */
#ifndef OUTPUT_TABLE_H
#define OUTPUT_TABLE_H

#include "base/state.h"

struct table;

/* The names of columns, which are made one after the other. */
struct table_head {
    int n;
    char **name;
};
void table_head_add(struct table_head *h, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void table_head_clear(struct table_head *h);

/* A new table, with its head; the names are "name [unit]". NULL after a
 * message. */
struct table *table_create(const char *path, int n_columns,
                           const char *const *names);

/* Opens a table to continue it. NULL after a message, also if the columns
 * differ. */
struct table *table_open(const char *path, int n_columns,
                         const char *const *names);
void table_free(struct table *t);

/* The rows so far (state.h): flushes them to the disk, or cuts off those that
 * came later. */
void table_state(struct table *t, struct state *s);

/* Adds a row of n_columns numbers; non-zero after a message. */
int table_add(struct table *t, const double *row);

/* A whole table at once, rows side by side: values[n_columns * row + column];
 * non-zero after a message. */
int table_write(const char *path, int n_columns, const char *const *names,
                int n_rows, const double *values);

#endif
