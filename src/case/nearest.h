/* nearest.h -- the known word nearest to a misspelt one.
 *
 * Near means few edits: a letter inserted, left out, replaced, or two
 * neighbours swapped; capitals do not count. A word that merely begins the
 * known one counts as one edit, so that "visc" finds "viscosity".
 */
#ifndef CASE_NEAREST_H
#define CASE_NEAREST_H

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

#endif
