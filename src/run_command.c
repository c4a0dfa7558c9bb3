/* SPDX-License-Identifier: GPL-3.0-or-later */
/* run_command.c -- `winnow run`: what the case needs and leaves out is said
 * before it runs; its page, where it asks for one, after it. */
#include "case/command.h"
#include "tell/check.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/interrupt.h"
#include "case/case_file.h"
#include "case/resume/resume.h"
#include "case/run.h"
#include "coupling/effect.h"
#include "coupling/processes.h"
#include "report/page.h"

/* One process of several says nothing. */
static void tell_of_effects(const struct settings *s)
{
    struct effect_row row[CHECK_EFFECTS];
    char verdict[CHECK_VERDICT];

    if (!s->has.particles || processes_engine != NULL) return;
    const struct case_scales in = case_scales_of(s);
    struct effect_scales k = check_scales(s, &in);
    const int n = k.force > 0.0 ? check_effect_rows(s, &k, &in, row) : 0;
    for (int i = 0; i < n; i++) {
        check_verdict(&row[i], verdict);
        if (!row[i].named && strncmp(verdict, "needed", 6) == 0)
            fprintf(stderr,
                    "winnow: effects.%s is off, and %s; see winnow check\n",
                    row[i].effect->name, verdict);
    }
}

/* out/NAME for a case some/where/NAME.cfg, as a new string. Of a name that
 * begins with a dot nothing is cut off, because ".cfg" would become "". */
static char *default_dir_of(const char *file)
{
    const char *const slash = strrchr(file, '/');
    const char *const name = slash != NULL ? slash + 1 : file;
    char *const dir = file_join("out", name);
    char *const dot = strrchr(dir, '.');

    if (dot != NULL && name[0] != '.') *dot = '\0';
    return dir;
}

static int run_act(const struct command_line *l)
{
    int code;
    struct interrupt_watch watch;

    /* With --quiet there are only files, and errors on stderr. */
    if (l->quiet && freopen("/dev/null", "w", stdout) == NULL) return 4;
    char *const dir = default_dir_of(l->words[0]);
    const struct run_options o = {.dir = l->dir != NULL ? l->dir : dir,
                                  .resume = l->resume,
                                  .fresh = l->fresh,
                                  .n_overrides = l->n_overrides,
                                  .overrides = l->overrides};

    interrupt_hold();
    interrupt_watch_begin(&watch, NULL, NULL);
    struct settings *const s =
        case_file_read(l->words[0], l->n_overrides, l->overrides, &code);
    interrupt_watch_end(&watch);
    if (l->threads > 0) omp_set_num_threads(l->threads);
    if (s != NULL && l->quiet) s->quiet = 1;
    if (s != NULL && o.resume) resume_keep_step(s, o.dir);
    if (s != NULL && case_scales_is_auto(s) && !l->quiet)
        fprintf(stderr, "%s: particles.step = \"auto\" is %.4g s\n", o.dir,
                case_steps_length(s) / case_steps_within(s));
    if (s != NULL && !l->quiet) tell_of_effects(s);
    if (s != NULL) code = run_case(s, &o);
    if (s != NULL && s->output.report && code != 2 && code != 4) {
        const int told = report_pages(1, &o.dir);
        if (code == 0) code = told;
    }
    settings_free(s);
    free(dir);
    return code;
}

const struct command run_command = {
    "run",
    "CASE [-o DIR] [-s path.to.key=value]... [-j THREADS] [--resume] [--fresh] "
    "[--quiet]",
    "run a case; DIR is out/ and the name of the case if not given; --resume "
    "continues where the run in DIR ended, --fresh settles its bed anew, "
    "--quiet prints errors only",
    "osj-rf",
    1,
    1,
    run_act};
