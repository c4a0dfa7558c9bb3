/* table.h -- tables as CSV: a head line, then rows of numbers.
 *
 * The head names each column with its unit, "pressure_drop [Pa]". A history
 * grows by a row at a time; a row reaches the file in one piece or not at all,
 * so the file can be read while the run goes on and is valid after any end.
 */
#ifndef OUTPUT_TABLE_H
#define OUTPUT_TABLE_H

struct table;

/* A new table, with its head; the names are "name [unit]". NULL after a
 * message. */
struct table *table_create(const char *path, int n_columns,
                           const char *const *names);

/* Goes on with a table: keeps the whole rows whose first number, the time, is
 * below `time`. NULL after a message, also if the columns are others. */
struct table *table_resume(const char *path, int n_columns,
                           const char *const *names, double time);
void table_free(struct table *t);

/* Adds a row of n_columns numbers; non-zero after a message. */
int table_add(struct table *t, const double *row);

/* A whole table at once, rows side by side: values[n_columns * row + column];
 * non-zero after a message. */
int table_write(const char *path, int n_columns, const char *const *names,
                int n_rows, const double *values);

#endif
