/* csv.h -- tables of numbers with a line of names, read from files.
 *
 * The first line names the columns, separated by commas, semicolons or blanks;
 * what follows a name in brackets, its unit, is not read, and quotes around it
 * are dropped. Each further line has a number for each of them. Empty lines
 * and lines that begin with # are passed over, and so is the mark of UTF-8 with
 * which spreadsheets begin a file.
 */
#ifndef BASE_TABLES_CSV_H
#define BASE_TABLES_CSV_H

#define CSV_UTF_8 "\xef\xbb\xbf"

enum { CSV_COLUMNS = 64, CSV_NAME = 32, CSV_WRONG = 256 };

struct csv {
    int n_columns, n_rows;
    char name[CSV_COLUMNS][CSV_NAME];
    double *value; /* n_columns of each row */
};

/* Non-zero if it cannot be read; `wrong` says why, with the line. */
int csv_read(struct csv *t, const char *path, char wrong[CSV_WRONG]);
/* The same of a text, which it changes. */
int csv_parse(struct csv *t, char *text, char wrong[CSV_WRONG]);
void csv_release(struct csv *t);

/* The number of a column, or -1. */
int csv_column(const struct csv *t, const char *name);

/* The names of its columns, "x y z u". */
void csv_names(const struct csv *t, char *text, int room);

#endif
