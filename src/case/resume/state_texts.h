/* state_texts.h -- what a saved state says about its run. */
#ifndef CASE_RESUME_STATE_TEXTS_H
#define CASE_RESUME_STATE_TEXTS_H

#include "case/run.h"
#include "output/checkpoint/state_file.h"

/* The program, the case file and its text, the overrides, and the lines of the
 * case (case_text.h). */
void state_texts_put(struct state_file *f, const struct settings *s,
                     const struct run_options *o, const char *lines);

/* A warning if another version of the program has written the file `path`. */
void state_texts_print_version(struct state_file *f, const char *path);

#endif
