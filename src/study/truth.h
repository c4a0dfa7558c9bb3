/* truth.h -- what the measures of a study are compared with.
 *
 *     0.0574, 0.05*(1-exp(-t/4e-4))
 *                     a formula; t, x, y, z are the first column
 *     XS11:4.1 u=0.05 d=8.3e-5 ...
 *                     an equation of `winnow eval`; an input t or x that is
 *                     left out is the first column
 *     measured.csv    the first two columns of a table, of which the first
 *                     rises; a row without a value is a gap, drawn across
 *     finest          the last entry of every choice
 *     extrapolated    Richardson's, along the axis, from the last three
 *                     entries; its order is told
 *     none            the measure is only listed
 */
#ifndef STUDY_TRUTH_H
#define STUDY_TRUTH_H

#include "study/curve.h"

/* Functions of one variable. Each kind is a descriptor. */
struct truth_function {
    const char *name; /* for messages: "a formula" */
    /* 1 if the text is meant for this kind. */
    int (*is_meant)(const char *text);
    /* NULL after a message. */
    void *(*create)(const char *text);
    double (*value)(const void *of, double x);
    void (*free)(void *of);
};

enum truth_kind {
    TRUTH_FUNCTION,
    TRUTH_TABLE,
    TRUTH_FINEST,
    TRUTH_EXTRAPOLATED,
    TRUTH_NONE
};

struct truth {
    enum truth_kind kind;
    char *text; /* as it was given */
    const struct truth_function *function;
    void *of;
    struct curve table;
};

/* 0; or after a message 2 for a text that is none of these, 4 for a table that
 * cannot be read. */
int truth_parse(struct truth *t, const char *text);
void truth_free(struct truth *t);

/* 1 if a text is the name of a table. */
int truth_is_table(const char *text);

/* Of a function or a table; nan where a table has nothing. */
double truth_value(const struct truth *t, double x);

#endif
