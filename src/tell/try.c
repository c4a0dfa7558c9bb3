/* SPDX-License-Identifier: GPL-3.0-or-later */
/* try.c -- `winnow check CASE --try SECONDS`: the estimates of the effects
 * beside a measurement.  Chapter "How to choose effects".
 *
 * The case runs for that long with every effect on that could matter, which
 * measures how large each is, and once more without each of them, which shows
 * what that changes and what time it takes. Two more runs show which changes
 * are chance: one with a slightly different tolerance, and one with other
 * seeds, as two beds that bubble are not alike. The runs are processes of this
 * program in a folder of their own, in which the bed settles once, and which is
 * removed. */
#include "case/command.h"
#include "tell/check.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/interrupt.h"
#include "base/text.h"
#include "case/case_file.h"
#include "output/summary.h"
#include "coupling/effects.h"

extern char **environ; /* POSIX: the program declares it itself */

/* [-] size from which on an effect is tried, and how far a tolerance is
 * changed. */
static const double tried_from = 0.005, changed = 0.9;

enum { WORD = 512, NAME = 64 };

struct attempt {
    const struct command_line *line;
    char dir[NAME];        /* of the runs; "" if there is none */
    double seconds;        /* [s] of a run */
    double end;            /* [s] of the case */
    double jet;            /* [Pa] that a jet brings; 0: there is none */
    int has_file;          /* [-] 1: the case names a file for its bed */
    _Atomic pid_t process; /* the one that runs; 0: none */
    int n;                 /* [-] effects that are tried */
    atomic_int stopped;    /* [-] 1: a signal has come, or all is done */
    struct effect_row row[CHECK_EFFECTS];
    char on[CHECK_EFFECTS][EFFECT_TRIAL]; /* their groups; "" as in the case */
};

/* What a run came to. */
struct outcome {
    int code;
    double speed, drop, time; /* [m/s], [Pa], [s] */
    double drop_of;           /* [Pa] of which its change is told */
    double share[CHECK_EFFECTS];
};

/* Starts a program, whose words go to a file; its exit code. Once a signal has
 * come, nothing more is started: the thread that waits for it (interrupt.h)
 * cleans up and ends the program. */
static int try_spawn(struct attempt *a, const char *program,
                     const char *const *words)
{
    posix_spawn_file_actions_t where;
    int status = 0;
    char log[2 * NAME];

    snprintf(log, sizeof log, "%s/log", a->dir);
    posix_spawn_file_actions_init(&where);
    posix_spawn_file_actions_addopen(&where, 1, log,
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&where, 1, 2);
    pid_t process = 0;
    errno = posix_spawnp(&process, program, &where, NULL,
                         (char *const *)(size_t)words, environ);
    posix_spawn_file_actions_destroy(&where);
    if (errno != 0) return 4;
    a->process = process;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR)
        ;
    a->process = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : INTERRUPT_CODE;
}

/* Runs this program. */
static int try_start(struct attempt *a, const struct texts *words)
{
    while (a->stopped)
        pause();
    const int code =
        try_spawn(a, "/proc/self/exe", (const char *const *)words->text);
    while (a->stopped)
        pause();
    return code;
}

/* Nothing is left behind. */
static void try_clean_up(void *data)
{
    struct attempt *const a = data;
    const char *const words[] = {"rm", "-rf", "--", a->dir, NULL};

    a->stopped = 1;
    const pid_t process = a->process;
    if (process > 0) {
        kill(process, SIGKILL);
        waitpid(process, NULL, 0);
    }
    if (a->dir[0] != '\0') try_spawn(a, "rm", words);
}

/* What the user has said, and what all runs have. */
static struct texts try_begin(const struct attempt *a, const char *command)
{
    struct texts w = {0};

    texts_add(&w, "winnow");
    texts_add(&w, "%s", command);
    texts_add(&w, "%s", a->line->words[0]);
    for (int i = 0; i < a->line->n_overrides; i++)
        texts_add(&w, "-s%s", a->line->overrides[i]);
    texts_add(&w, "-soutput.end=%.17g", a->seconds);
    texts_add(&w, "-soutput.every=%.17g", a->seconds);
    texts_add(&w, "-soutput.picture=false");
    texts_add(&w, "-soutput.animation=false");
    if (a->has_file) texts_add(&w, "-sparticles.bed.file=off");
    return w;
}

/* Puts on what is tried, but for one; -1: none is left out. */
static void try_choose(const struct attempt *a, int without, struct texts *w)
{
    for (int i = 0; i < a->n; i++) {
        const char *const group = i == without ? "off" : a->on[i];
        if (group[0] != '\0')
            texts_add(w, "-seffects.%s=%s", a->row[i].effect->name, group);
    }
}

/* Runs the case without the i-th, or with all, and with further overrides. */
static struct outcome try_run(struct attempt *a, int without,
                              const struct texts *more)
{
    struct texts w = try_begin(a, "run");
    char dir[2 * NAME], path[WORD];
    struct outcome o;

    snprintf(dir, sizeof dir, "%s/run", a->dir);
    try_choose(a, without, &w);
    for (int i = 0; more != NULL && i < more->n; i++)
        texts_add(&w, "-s%s", more->text[i]);
    texts_add(&w, "-j%d", a->line->threads > 0 ? a->line->threads : 1);
    texts_add(&w, "-o%s", dir);
    texts_add(&w, "--quiet");
    o.code = try_start(a, &w);
    texts_free(&w);
    o.speed = read_summary_number(dir, "second_half.particle_velocity_rms");
    o.drop = read_summary_number(dir, "second_half.mean_pressure_drop");
    o.drop_of = fmax(fabs(o.drop), a->jet);
    o.time = read_summary_number(dir, "seconds.processor");
    for (int i = 0; i < a->n; i++) {
        snprintf(path, sizeof path, "effects.%s.mean_share",
                 a->row[i].effect->name);
        o.share[i] = read_summary_number(dir, path);
    }
    return o;
}

/* What the last program said, to stderr. */
static void try_repeat(const struct attempt *a)
{
    char log[2 * NAME], line[WORD];

    snprintf(log, sizeof log, "%s/log", a->dir);
    FILE *const f = fopen(log, "r");
    while (f != NULL && fgets(line, sizeof line, f) != NULL)
        fputs(line, stderr);
    if (f != NULL) fclose(f);
}

/* 1 if `check` takes the case with an effect that it does not name. */
static int try_is_allowed(struct attempt *a, const struct effect_row *r,
                          const char *group)
{
    struct texts w = try_begin(a, "check");

    texts_add(&w, "-seffects.%s=%s", r->effect->name, group);
    const int code = try_start(a, &w);
    texts_free(&w);
    return code == 0;
}

/* Those that are on, and those off that could matter and can be put on. */
static void try_candidates(struct attempt *a, const struct settings *s)
{
    const struct case_scales in = case_scales_of(s);
    struct effect_scales k = check_scales(s, &in);

    a->jet = k.rho_f * in.up * in.jet;
    struct effect_row all[CHECK_EFFECTS];
    const int n = k.force > 0.0 ? check_effect_rows(s, &k, &in, all) : 0;

    for (int i = 0; i < n; i++) {
        const struct effect *const e = all[i].effect;
        char group[EFFECT_TRIAL] = "{}";

        if (e == &gravity_effect || e->estimate == NULL ||
            all[i].instead != NULL)
            continue;
        if (e->trial != NULL) e->trial(&k, group);
        if (!all[i].named && (all[i].estimate.share < tried_from ||
                              !try_is_allowed(a, &all[i], group)))
            continue;
        snprintf(a->on[a->n], EFFECT_TRIAL, "%s", all[i].named ? "" : group);
        a->row[a->n++] = all[i];
    }
}

/* [%]; nan: it has no such number. */
static double change(double without, double with, double of)
{
    return of != 0.0 ? 100.0 * (without - with) / fabs(of) : NAN;
}

static double change_of_speed(const struct outcome *without,
                              const struct outcome *with)
{
    return change(without->speed, with->speed, with->speed);
}

static double change_of_drop(const struct outcome *without,
                             const struct outcome *with)
{
    return change(without->drop, with->drop, with->drop_of);
}

static void put_change(char cell[32], double change)
{
    snprintf(cell, 32, "-");
    if (isfinite(change)) snprintf(cell, 32, "%+.2g", change);
}

static void try_row(const char *name, const char *estimate, double measured,
                    const struct outcome *without, const struct outcome *with,
                    const char *remark)
{
    char cell[5][32] = {"-", "-", "-", "-", "-"};

    if (measured > 0.0) /* of a force */
        snprintf(cell[1], sizeof cell[1], "%.3g", 100.0 * measured);
    if (without->code == 0) {
        put_change(cell[2], change_of_speed(without, with));
        put_change(cell[3], change_of_drop(without, with));
        put_change(cell[4], change(with->time, without->time, without->time));
    }
    printf("  %-18s %9s %9s %9s %9s %9s  %s\n", name, estimate, cell[1],
           cell[2], cell[3], cell[4],
           without->code != 0 ? "the run breaks down" : remark);
}

/* The runs that differ by chance alone: with other rounding, where a fluid has
 * a tolerance, and with other seeds, where the case has any. */
enum { CHANCES = 2 };
struct chances {
    int n;
    const char *name[CHANCES];
    struct outcome of[CHANCES];
};

static void add_chance(struct attempt *a, const char *name, struct texts *more,
                       struct chances *c)
{
    if (more->n > 0) {
        c->name[c->n] = name;
        c->of[c->n++] = try_run(a, -1, more);
    }
    texts_free(more);
}

static struct chances try_chances(struct attempt *a, const struct settings *s)
{
    struct texts rounding = {0}, seeds = {0};
    struct chances c = {0};

    if (s->has.fluid)
        texts_add(&rounding, "fluid.tolerance=%g",
                  changed * s->fluid.tolerance);
    case_file_add_seeds(s, 1, &seeds);
    add_chance(a, "(other rounding)", &rounding, &c);
    add_chance(a, "(other seed)", &seeds, &c);
    return c;
}

/* 1 if a change of speed and drop is not above what chance gives. */
static int is_chance(const struct chances *c, const struct outcome *without,
                     const struct outcome *with)
{
    double speed = 0.0, drop = 0.0; /* [%] the largest by chance */

    for (int i = 0; i < c->n && c->of[i].code == 0; i++) {
        speed = fmax(speed, fabs(change_of_speed(&c->of[i], with)));
        drop = fmax(drop, fabs(change_of_drop(&c->of[i], with)));
    }
    return !(fabs(change_of_speed(without, with)) > speed) &&
           !(fabs(change_of_drop(without, with)) > drop);
}

static void try_rows(struct attempt *a, const struct settings *s,
                     const struct outcome *with)
{
    const struct chances c = try_chances(a, s);

    printf("Effects in %g s: size, and what changes without each of them\n"
           "  %-18s %9s %9s %9s %9s %9s\n  %-18s %9s %9s %9s %9s %9s\n",
           a->seconds, "", "estimate", "measured", "speed", "drop", "time", "",
           "%", "%", "%", "%", "% of run");
    for (int i = 0; i < a->n; i++) {
        const struct effect_row *const r = &a->row[i];
        const struct outcome without = try_run(a, i, NULL);
        char estimate[CHECK_SIZE], remark[64];
        check_size(&r->estimate, estimate);
        snprintf(remark, sizeof remark, "%s%s", r->named ? "on" : "off",
                 is_chance(&c, &without, with)
                     ? ", within what another start gives"
                     : "");
        try_row(r->effect->name, estimate, with->share[i], &without, with,
                remark);
    }
    for (int i = 0; i < c.n; i++)
        try_row(c.name[i], "-", NAN, &c.of[i], with, "all on");
    if (a->jet > fabs(with->drop))
        printf("  the drop, %.3g Pa, is a difference of larger ones: its "
               "changes are in %% of the\n  %.3g Pa that the jet brings\n",
               with->drop, a->jet);
}

static int try_table(struct attempt *a, const struct settings *s)
{
    const struct outcome with = try_run(a, -1, NULL);

    if (with.code != 0) {
        try_repeat(a);
        fprintf(stderr,
                "winnow: with all effects on that could matter the run ends "
                "with code %d; leave one out with -s effects.NAME=off\n",
                with.code);
        return with.code;
    }
    try_rows(a, s, &with);
    printf("  to its end, %g s, the case takes about %.3g s of one core with "
           "all of them\n",
           a->end, with.time * a->end / a->seconds);
    return 0;
}

static double try_seconds(const char *text)
{
    char *end;
    const double x = strtod(text, &end);

    return end != text && *end == '\0' && isfinite(x) ? x : 0.0;
}

int check_try(const struct command_line *l)
{
    const char *const tmp = getenv("TMPDIR");
    struct attempt *const a = calloc(1, sizeof *a);
    struct interrupt_watch watch;
    int code = 4;

    if (a == NULL) return 4;
    a->line = l;
    a->seconds = try_seconds(l->words[1]);
    interrupt_hold();
    interrupt_watch_begin(&watch, try_clean_up, a);
    struct settings *const s =
        case_file_read(l->words[0], l->n_overrides, l->overrides, &code);
    if (s != NULL && !(a->seconds > 0.0)) {
        fprintf(stderr, "winnow: --try %s: expected a number of seconds > 0\n",
                l->words[1]);
        code = 2;
    } else if (s != NULL) {
        a->end = s->output.end;
        a->seconds = fmin(a->seconds, a->end);
        s->output.end = a->seconds;
        a->has_file = s->particles.bed_file != NULL;
        snprintf(a->dir, sizeof a->dir, "%s/winnow-try-XXXXXX",
                 tmp != NULL && strlen(tmp) < NAME / 2 ? tmp : "/tmp");
        code = mkdtemp(a->dir) != NULL ? 0 : 4;
        if (code == 0) try_candidates(a, s);
        if (code == 0) code = try_table(a, s);
        try_clean_up(a);
    }
    interrupt_watch_end(&watch);
    settings_free(s);
    free(a);
    return code;
}
