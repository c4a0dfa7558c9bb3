/* models.h -- every model that a case can choose, by kind.
 *
 * Where a module has a table of its models, the rows here are made from that
 * table; only models without a table are listed in models.c.
 */
#ifndef CASE_MODELS_H
#define CASE_MODELS_H

struct model {
    const char *name;     /* as a case spells it */
    const char *what;     /* one line */
    const char *source;   /* where it comes from, "" if nowhere in particular */
    const char *function; /* that computes it */
    const char *keys;     /* paths of the keys it reads, apart by blanks */
};

struct kind {
    const char *name; /* "drag" */
    const char *what; /* "drag laws" */
    const char *key;  /* that chooses: "exchange.drag" */
    /* The i-th model; 0 past the last. */
    int (*model)(int i, struct model *m);
};

/* All kinds, ended by one without a name. */
extern const struct kind models_kinds[];

/* The kind of that name, or NULL. */
const struct kind *models_kind(const char *name);

#endif
