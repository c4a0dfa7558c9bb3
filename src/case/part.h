/* part.h -- a part of a case that a folder brings.
 *
 * A part has a group of keys, a place in the simulation as an effect
 * (coupling/effect.h), and files of its own. The folder lists it in its
 * models.txt; without the folder the case does not know the group. Of a part
 * that a case does not name nothing is called.
 */
#ifndef CASE_PART_H
#define CASE_PART_H

#include "base/model.h"
#include "case/history.h"
#include "case/settings.h"
#include "output/folder.h"
#include "output/summary.h"

struct case_part {
    const char *name;                   /* its group in a case */
    const char *what;                   /* one line */
    const char *equations;              /* keys in chapters/references.md */
    const char *function;               /* the one that computes it */
    const struct key *keys[KEY_TABLES]; /* tables of its keys */
    /* 0, or 2 after a message. */
    int (*validate)(const struct settings *s);
    /* Adds itself to the effects of the simulation; returns the exit code. */
    int (*create)(const struct settings *s, struct simulation *sim);
    void (*report)(const struct settings *s); /* its section of `check` */
    const struct history_column *columns;     /* of history.csv; ended by one
                                                 without a name */
    /* Its files: a record is NULL after a message, and each call non-zero. */
    void *(*record)(const struct simulation *sim, struct folder *folder);
    int (*add_row)(void *record);
    int (*add_fields)(void *record, double t);
    void (*summarize)(const void *record, struct summary *f);
    void (*print)(const void *record); /* on stdout, at the end */
    void (*free)(void *record);
};

/* All parts, ended by NULL. */
extern const struct case_part *const case_parts[];

/* How a body holds the fluid; ended by NULL. */
extern const struct model *const body_methods[];

/* Adds their tables of keys from tables[n] on; how many there are then. */
int part_tables(const struct key **tables, int n, int room);

/* The same for all parts that the case names. */
int part_validate(const struct settings *s);
int part_create(const struct settings *s, struct simulation *sim);
void part_report(const struct settings *s);

/* Their columns of history.csv, at most `room`; how many. */
int part_columns(const struct settings *s, int room,
                 const struct history_column **column);

/* Their files. NULL without parts; *failed is then 1 after a message. */
struct part_records *part_records_create(const struct settings *s,
                                         const struct simulation *sim,
                                         struct folder *folder, int *failed);
void part_records_free(struct part_records *r);
int part_records_add_row(struct part_records *r);
int part_records_add_fields(struct part_records *r, double t);
void part_records_summarize(const struct part_records *r, struct summary *f);
void part_records_print(const struct part_records *r);

#endif
