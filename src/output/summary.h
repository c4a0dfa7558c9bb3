/* summary.h -- the summary of a run as JSON.
 *
 * Entries appear in the order in which they are added, groups in braces.
 * Numbers read back to the same bits; nan and inf are written as null, because
 * JSON has no notation for them.
 */
#ifndef OUTPUT_SUMMARY_H
#define OUTPUT_SUMMARY_H

struct summary;

/* NULL after a message; all the others accept NULL and do nothing. */
struct summary *summary_create(const char *path);

void summary_number(struct summary *s, const char *key, double value);
void summary_count(struct summary *s, const char *key, long long value);
void summary_text(struct summary *s, const char *key, const char *value);

/* Begin a group of entries, which may contain groups, and end the last one. */
void summary_begin(struct summary *s, const char *key);
void summary_end(struct summary *s);

/* Ends the file, which appears when it is complete, and releases s. Non-zero
 * after a message, also for NULL. */
int summary_commit(struct summary *s);

/* --- read summary: reads back what summary.json says (output/summary.h). */

/* A number of the summary.json in a folder by its path, "seconds.cfd"; nan if
 * it is not there or null. */
double read_summary_number(const char *folder, const char *path);

/* A text of it; NULL if it is not there. To be freed. */
char *read_summary_text(const char *folder, const char *path);

#endif
