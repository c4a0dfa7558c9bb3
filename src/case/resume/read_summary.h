/* read_summary.h -- reads back what summary.json says (output/summary.h). */
#ifndef CASE_RESUME_READ_SUMMARY_H
#define CASE_RESUME_READ_SUMMARY_H

/* A number of the summary.json in a folder by its path, "seconds.cfd"; nan if
 * it is not there or null. */
double read_summary_number(const char *folder, const char *path);

/* A text of it; NULL if it is not there. To be freed. */
char *read_summary_text(const char *folder, const char *path);

#endif
