/* results.h -- reads back the tables that a run has written. */
#ifndef STUDY_RESULTS_H
#define STUDY_RESULTS_H

/* A table of table.h: rows side by side, value[n_columns * row + column]. */
struct results_table {
    int n_columns, n_rows;
    char **name; /* with the unit: "pressure_drop [Pa]" */
    double *value;
};

/* A head and rows of as many numbers; lines that begin with # and empty ones
 * are left out, and an empty field is nan. NULL, without a message, if there is
 * no such table; *wrong is then the line that is no row, 0 if there are no
 * rows, -1 if there is no such file. If `wrong` is NULL the table is that of a
 * run, and a last line without an end was cut, and is left out. */
struct results_table *results_table_read(const char *path, int *wrong);
void results_table_free(struct results_table *t);

/* The column of a name without its unit; of a probe, "us_y(0.1 0.2 0.3) [m/s]",
 * the name of the field will do. -1 if there is none. */
int results_column(const struct results_table *t, const char *name);

#endif
