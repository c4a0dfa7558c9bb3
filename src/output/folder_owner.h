/* folder_owner.h -- the hook by which a folder is kept for one run.
 *
 * What take returns is given to the other functions; those that return a number
 * return non-zero after a message.
 */
#ifndef OUTPUT_FOLDER_OWNER_H
#define OUTPUT_FOLDER_OWNER_H

#include "base/state.h"

struct folder_owner {
    void *(*take)(const char *dir);  /* NULL after a message */
    int (*prepare)(void *own);       /* before a file that begin must keep */
    int (*is_used)(const void *own); /* 1: files of an earlier run are there */
    int (*begin)(void *own);         /* removes them */
    void (*resume)(void *own);       /* instead of begin */
    int (*list)(void *own, const char *name); /* before the file is made */
    void (*state)(void *own, struct state *s);
    void (*leave)(void *own); /* of a run that did not begin */
    void (*free)(void *own);
};

/* Ended by NULL: there is one, or none. */
extern const struct folder_owner *const folder_owners[];

#endif
