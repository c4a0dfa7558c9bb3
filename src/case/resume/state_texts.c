/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resume/state_texts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/text.h"

static const char program[] = "winnow " VERSION_TEXT;

void state_texts_put(struct state_file *f, const struct settings *s,
                     const struct run_options *o, const char *lines)
{
    const char *const text =
        input_kept(settings_files(s), settings_file(s))->text;

    state_file_put_text(f, "program", program);
    state_file_put_text(f, "case_file", settings_file(s));
    state_file_put_text(f, "case", text != NULL ? text : "");
    state_file_put_text(f, "settings", lines);
    char step[32];
    snprintf(step, sizeof step, "%.17g", s->particles.step);
    state_file_put_text(f, "particles_step", step);
    for (int i = 0; i < o->n_overrides; i++) {
        char name[32];
        snprintf(name, sizeof name, "override_%d", i + 1);
        state_file_put_text(f, name, o->overrides[i]);
    }
}

void state_texts_print_version(struct state_file *f, const char *path)
{
    char *const by = state_file_text(f, "program");

    text_blank(by);
    if (strcmp(by, program) != 0)
        fprintf(stderr,
                "winnow: %s was written by %s; this is %s, whose numbers may "
                "differ\n",
                path, by, program);
    free(by);
}
