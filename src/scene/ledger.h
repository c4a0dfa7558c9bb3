/* ledger.h -- `winnow explain KEY`: from an equation of the documents to its
 * function, its tests, its paragraph and its `eval` key.
 *
 * The table is that of the book, chapters/equations.md, which `make weave`
 * gathers from the keys in source, tests and chapters; the build turns it into
 * C.
 */
#ifndef LEDGER_H
#define LEDGER_H

enum ledger_kind {
    LEDGER_SAYS,     /* name: what the equation says */
    LEDGER_STATUS,   /* name: what is missing yet */
    LEDGER_AS,       /* name: the key of the equation that stands for it */
    LEDGER_FUNCTION, /* name and file, and so below */
    LEDGER_TEST,
    LEDGER_SECTION
};

/* One thing that is known of an equation. */
struct ledger_row {
    const char *key; /* "XS11 2.13" */
    enum ledger_kind kind;
    const char *name, *file;
};

/* All of them, those of an equation together; ended by one without a key. */
extern const struct ledger_row ledger_rows[];

/* 1 if the word is meant as a key, XS11:2.13 or "XS11 2.13", or as a
 * document, XS11, and not as the name of a case file. */
int ledger_is_key(const char *word);

/* Prints what is known of an equation, or of all parts (5a, 5b, ...) of one;
 * of a document, a line for each. Returns the exit code: 0, or 2 after a
 * message that names the nearest. */
int ledger_explain(const char *key);

#endif
