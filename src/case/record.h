/* record.h -- what a case may have written besides, each in one descriptor.
 *
 * A record that a case does not name allocates nothing and is not called.
 */
#ifndef CASE_RECORD_H
#define CASE_RECORD_H

#include "case/settings.h"
#include "coupling/simulation.h"
#include "output/folder.h"

struct record {
    const struct key *keys; /* the first is the key under `output` that
                               switches it on */
    /* 0 if what the case says can be; else 2 after a message. May be NULL. */
    int (*check)(const struct settings *s);
    /* NULL after a message. All arguments are borrowed. */
    void *(*create)(const struct settings *s, const struct simulation *sim,
                    struct folder *folder);
    /* With each row of history.csv, and with each picture; non-zero after a
     * message. Either may be NULL. */
    int (*add_row)(void *memory);
    int (*add_picture)(void *memory);
    void (*free)(void *memory); /* NULL is fine */
};

extern const struct record *const records[]; /* ended by NULL */

/* Those that a case names. records_create returns NULL after a message. */
struct records;
int records_check(const struct settings *s);
struct records *records_create(const struct settings *s,
                               const struct simulation *sim,
                               struct folder *folder);
int records_add_row(struct records *r);
int records_add_picture(struct records *r);
void records_free(struct records *r);

#endif
