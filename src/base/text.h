/* text.h -- texts of strangers, where they leave the program.
 *
 * A title, a name, a value of a study: whoever wrote the case chose it, and it
 * ends in a script, a page or a terminal of whoever runs it. No case and no
 * command line may have a control character in a text (text_control), and what
 * is written is written by text_put, in the quotes of its target.
 */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include <stdio.h>

/* The version of the program, for --version and summaries. */
#define VERSION_TEXT "0.1.0"

/* The first control character, such as a line break or an escape code; NULL if
 * there is none. */
const char *text_control(const char *text);

/* Puts blanks in the place of control characters. */
void text_blank(char *text);

/* Prints what is wrong with a file on stderr, with the line unless that is 0,
 * and blanks in the place of control characters; returns 1. */
int text_wrong(const char *path, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

enum text_target {
    TEXT_PLAIN,   /* a line of a terminal */
    TEXT_SHELL,   /* a word of a command */
    TEXT_GNUPLOT, /* a text of a script, in quotes */
    TEXT_DATA,    /* a column of gnuplot's data */
    TEXT_LAMMPS,  /* a remark in a deck */
    TEXT_CASE,    /* a text of a case, in quotes */
    TEXT_CSV,     /* a field, in quotes if it needs them */
    TEXT_PAGE,    /* Markdown, in a table or not */
    TEXT_XML
};

/* Writes a text so that the target reads it as it is; of a control character,
 * and of what the target cannot quote, a sign in its place. */
void text_put(FILE *out, const char *text, enum text_target target);

/* Prints a number with its name, its unit and a remark: a line of what
 * `winnow check` tells. */
void text_line(const char *name, double value, const char *unit,
               const char *remark);

/* A growing list of texts. */
struct texts {
    int n;
    char **text; /* ended by NULL, once there is one */
};

/* Adds a text as printf makes it, and returns it; the list owns it. */
const char *texts_add(struct texts *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void texts_free(struct texts *t);

/* --- nearest: the known word nearest to a misspelt one.
 *
 * Near means few edits: a letter inserted, left out, replaced, or two
 * neighbours swapped; capitals do not count. A word that merely begins the
 * known one counts as one edit, so that "visc" finds "viscosity". */

enum { NEAREST_TEXT = 128 }; /* longer words are never near */

struct nearest {
    const char *wanted; /* borrowed */
    int edits;          /* of the best so far; above the limit: none */
    char best[NEAREST_TEXT];
};

/* Number of edits between two words, each shorter than NEAREST_TEXT. */
int nearest_edits(const char *a, const char *b);

/* Begin with the misspelt word, offer each known one, then ask: NULL if no
 * known word is near. Of equals the first offered wins. */
void nearest_init(struct nearest *n, const char *wanted);
void nearest_offer(struct nearest *n, const char *known);
const char *nearest_best(const struct nearest *n);

/* "; did you mean NAME?", or the other text if the name is NULL. */
enum { NEAREST_HINT = 640 };
const char *nearest_hint(const char *name, const char *other,
                         char text[NEAREST_HINT]);

#endif
