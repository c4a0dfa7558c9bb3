/* equation_index.h -- `winnow explain KEY`: from an equation of the documents
 * to its function, its tests, its paragraph and its `eval` key.
 *
 * The table is that of the book, chapters/equations.md, which `make weave`
 * gathers from the keys in source, tests and chapters; the build turns it into
 * C.
 */
#ifndef CASE_REPORT_EQUATION_INDEX_H
#define CASE_REPORT_EQUATION_INDEX_H

enum equation_index_kind {
    EQUATION_INDEX_SAYS,   /* name: what the equation says */
    EQUATION_INDEX_STATUS, /* name: what is missing yet */
    EQUATION_INDEX_AS, /* name: the key of the equation that stands for it */
    EQUATION_INDEX_FUNCTION, /* name and file, and so below */
    EQUATION_INDEX_TEST,
    EQUATION_INDEX_SECTION
};

/* One thing that is known of an equation. */
struct equation_index_row {
    const char *key; /* "XS11 2.13" */
    enum equation_index_kind kind;
    const char *name, *file;
};

/* All of them, those of an equation together; ended by one without a key. */
extern const struct equation_index_row equation_index_rows[];

/* 1 if the word is meant as a key, XS11:2.13 or "XS11 2.13", or as a
 * document, XS11, and not as the name of a case file. */
int equation_index_is_key(const char *word);

/* 1 if there are equations that a function of that name computes; these are
 * then printed. */
int equation_index_has_function(const char *name);
void equation_index_explain_function(const char *name);

/* Offers the names of all functions that compute an equation. */
struct nearest;
void equation_index_offer_functions(struct nearest *n);

/* Prints what is known of an equation, or of all parts (5a, 5b, ...) of one;
 * of a document, a line for each. Returns the exit code: 0, or 2 after a
 * message that names the nearest. */
int equation_index_explain(const char *key);

#endif
