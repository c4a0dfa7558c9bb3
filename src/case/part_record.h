/* part_record.h -- what the parts of case_part.h write.
 *
 * A part may add columns to history.csv, and have files of its own, with a row
 * for each of its rows and a file for each picture, and a group in the summary.
 */
#ifndef CASE_PART_RECORD_H
#define CASE_PART_RECORD_H

#include "case/history.h"
#include "output/folder.h"
#include "output/summary.h"

struct part_record_type {
    /* 1 if the simulation has the part; else nothing else is called. */
    int (*applies)(const struct simulation *sim);
    const struct history_column *columns; /* ended by one without a name */
    /* NULL after a message; the functions below return non-zero after one. */
    void *(*create)(const struct simulation *sim, struct folder *folder);
    int (*add_row)(void *record);
    int (*add_picture)(void *record, double t);
    void (*summarize)(const void *record, struct summary *f);
    void (*print)(const void *record); /* on stdout, at the end */
    void (*free)(void *record);
};

/* Their columns, at most `room`; how many. */
int part_record_columns(const struct simulation *sim, int room,
                        const struct history_column **column);

/* The records of all parts; NULL without any. *failed is 1 after a message. The
 * functions below do nothing for NULL. */
struct part_records *part_record_create(const struct simulation *sim,
                                        struct folder *folder, int *failed);
void part_record_free(struct part_records *r);
int part_record_add_row(struct part_records *r);
int part_record_add_picture(struct part_records *r, double t);
void part_record_summarize(const struct part_records *r, struct summary *f);
void part_record_print(const struct part_records *r);

#endif
