/* csv.h -- tables of numbers with a line of names, read from files.
 *
 * The first line names the columns, separated by commas, semicolons or blanks;
 * brackets after a name hold its unit, and quotes around it are dropped. Each
 * further line has a number for each of them. Empty lines and lines that begin
 * with # are passed over, and so is the mark of UTF-8 with which spreadsheets
 * begin a file. A remark before the first row that speaks of another unit of
 * length than m is an error.
 */
#ifndef BASE_CSV_H
#define BASE_CSV_H

#include "base/file.h"

#define CSV_UTF_8 "\xef\xbb\xbf"

enum { CSV_COLUMNS = 64, CSV_NAME = 32, CSV_WRONG = 256 };

struct csv {
    int n_columns, n_rows;
    char name[CSV_COLUMNS][CSV_NAME], unit[CSV_COLUMNS][CSV_NAME];
    double *value; /* n_columns of each row */
};

/* Non-zero if it cannot be read; `wrong` says why, with the line. */
int csv_read(struct csv *t, const struct input *in, char wrong[CSV_WRONG]);
/* The same of a text, which it changes. With `names` it may begin with a row:
 * the columns are then those of the remark before it, or else `names`. */
int csv_parse(struct csv *t, char *text, const char *names,
              char wrong[CSV_WRONG]);
void csv_release(struct csv *t);

/* The number of a column, or -1. */
int csv_column(const struct csv *t, const char *name);

/* Non-zero if the file states another unit of this column. */
int csv_check_unit(const struct csv *t, int column, const char *unit,
                   char wrong[CSV_WRONG]);

/* The names of its columns, "x y z u". */
void csv_names(const struct csv *t, char *text, int room);

#endif
