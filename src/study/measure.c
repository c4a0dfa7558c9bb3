/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/curve.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/statistics.h"
#include "record/history.h"
#include "base/text.h"
#include "record/recorder_part.h"
#include "output/summary.h"
#include "study/plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Numbers of summary.json, each with a blank before and behind; of a group that
 * ends with a point all are taken. */
static const char in_summary[] =
    " steps cells particles particle_steps_in_a_step particles_in "
    "particles_out particles_waiting step simulated_seconds peak_memory "
    "particle_steps_per_second cell_steps_per_second seconds.cfd seconds.dem "
    "seconds.averaging seconds.exchange seconds.output seconds.total "
    "seconds.processor worst.mass_residual worst.momentum_residual worst.cfl "
    "worst.exchange_residual worst.eps_f_lowest worst.steps_with_capped_cells "
    "worst.overlap second_half. profiles. effects. effect_seconds. bodies. ";

static int measure_refuse(const struct measure *m, const char *why)
{
    return plan_wrong("measure %s: %s", m->text, why);
}

/* --- what is meant -------------------------------------------------------- */

/* Takes "mean:" and the like off; the rest. A profile is a curve. */
static const char *take_how(struct measure *m, const char *text)
{
    static const char *const words[] = {
        "last:", "mean:", "max:", "min:", "curve:"};

    for (int i = 0; i < 5; i++)
        if (strncmp(text, words[i], strlen(words[i])) == 0) {
            m->how = (enum measure_how)i;
            return text + strlen(words[i]);
        }
    m->how = strncmp(text, "profile.", 8) == 0 ? MEASURE_CURVE : MEASURE_LAST;
    return text;
}

/* Reads "@FROM", "@FROM..TO" or nothing; non-zero if it is none of them. */
static int take_range(struct measure *m, const char *text)
{
    char *end;

    m->from = m->to = NAN;
    if (text[0] == '\0') return 0;
    m->from = strtod(text + 1, &end);
    /* "0.3..0.6": the number has taken the first of the two points. */
    if (end > text + 1 && end[-1] == '.' && end[0] == '.') end--;
    if (end == text + 1 || !isfinite(m->from)) return 1;
    if (end[0] == '\0') return 0;
    if (strncmp(end, "..", 2) != 0 || m->how == MEASURE_LAST) return 1;
    text = end + 2;
    m->to = strtod(text, &end);
    return end == text || *end != '\0' || !(m->to > m->from) ||
           !isfinite(m->to);
}

/* "probe.1", "profile.0": the number; -1 if it is not that word. */
static int numbered(const char *name, const char *word)
{
    const size_t n = strlen(word);
    char *end;

    if (strncmp(name, word, n) != 0) return -1;
    const long number = strtol(name + n, &end, 10);
    return end == name + n || *end != '\0' || number < 0 || number > 9999
               ? -1
               : (int)number;
}

static int is_column(const struct history_column *c, const char *name)
{
    const size_t n = strlen(name);

    return strncmp(c->name, name, n) == 0 && c->name[n] == ' ';
}

/* Those of all runs, or of a folder. */
static const struct history_column *in_history(const char *name)
{
    for (const struct history_column *c = history_columns; c->name; c++)
        if (is_column(c, name)) return c;
    for (int i = 0; recorder_parts[i] != NULL; i++)
        for (const struct history_column *c = recorder_parts[i]->columns;
             c != NULL && c->name != NULL; c++)
            if (is_column(c, name)) return c;
    return NULL;
}

/* 1 if a case has what a column of the history needs, as far as it says. */
static int has_needed(const struct settings *s, int needs)
{
    return (!(needs & HISTORY_FLUID) || s->has.fluid) &&
           (!(needs & HISTORY_PARTICLES) || s->has.particles) &&
           (!(needs & HISTORY_COUPLING) || s->has.exchange);
}

static int is_in_summary(const char *name)
{
    const size_t group = strcspn(name, ".");
    char one[MEASURE_NAME + 3], all[MEASURE_NAME + 3];

    snprintf(one, sizeof one, " %s ", name);
    snprintf(all, sizeof all, " %.*s. ", (int)group, name);
    return strstr(in_summary, one) != NULL ||
           (name[group] == '.' && strstr(in_summary, all) != NULL);
}

/* The probe of that field, or -1. */
static int probe_of(const struct settings *s, const char *field)
{
    for (int i = 0; i < s->output.probes.n; i++)
        if (strcmp(s->output.probes.item[i].field, field) == 0) return i;
    return -1;
}

static int measure_unknown(const struct measure *m)
{
    struct nearest n;
    char name[MEASURE_NAME], hint[NEAREST_HINT];

    nearest_init(&n, m->name);
    for (const struct history_column *c = history_columns; c->name; c++) {
        snprintf(name, sizeof name, "%.*s", (int)strcspn(c->name, " "),
                 c->name);
        nearest_offer(&n, name);
    }
    for (const char *at = in_summary; (at = strchr(at, ' ')) != NULL; at++) {
        snprintf(name, sizeof name, "%.*s", (int)strcspn(at + 1, " "), at + 1);
        nearest_offer(&n, name);
    }
    return plan_wrong("measure %s: no column of history.csv or probes.csv is "
                      "called so, and no number of summary.json%s",
                      m->text, nearest_hint(nearest_best(&n), "", hint));
}

/* Where the measure is found in the folder of a run. */
static int measure_locate(struct measure *m, const struct settings *s)
{
    const int probe = numbered(m->name, "probe.");
    const int profile = numbered(m->name, "profile.");
    const char *const table = strstr(m->name, ".csv/");
    char name[PROFILES_NAME];

    m->column = -1;
    if (probe >= 0 || probe_of(s, m->name) >= 0) {
        strcpy(m->file, "probes.csv");
        m->column = 1 + (probe >= 0 ? probe : probe_of(s, m->name));
        if (m->column > s->output.probes.n)
            return measure_refuse(m,
                                  "output.probes of the case has not so many");
        snprintf(m->field, sizeof m->field, "%s",
                 s->output.probes.item[m->column - 1].field);
    } else if (profile >= 0) {
        if (profile >= s->output.profiles.n)
            return measure_refuse(
                m, "output.profiles of the case has not so many");
        profiles_name(&s->output, profile, name);
        snprintf(m->field, sizeof m->field, "%s",
                 s->output.profiles.item[profile].field);
        snprintf(m->file, MEASURE_NAME, "profiles/%s.csv", name);
        m->column = 1;
        if (m->how == MEASURE_LAST) m->how = MEASURE_CURVE;
    } else if (table != NULL) {
        snprintf(m->file, MEASURE_NAME, "%.*s", (int)(table + 4 - m->name),
                 m->name);
        memmove(m->name, table + 5, strlen(table + 5) + 1);
    } else if (in_history(m->name) != NULL) {
        strcpy(m->file, "history.csv");
        if (!has_needed(s, in_history(m->name)->needs))
            return measure_refuse(m,
                                  "the case has no such column, for want of a "
                                  "fluid, of particles or of their exchange");
    } else if (is_in_summary(m->name) && m->how == MEASURE_LAST)
        strcpy(m->file, "summary.json");
    else
        return measure_unknown(m);
    return 0;
}

int measure_parse(struct measure *m, const char *text, const struct settings *s)
{
    *m = (struct measure){.column = -1};
    snprintf(m->text, sizeof m->text, "%s", text);
    if (strlen(text) >= MEASURE_NAME)
        return measure_refuse(m, "too long a name");
    const char *const name = take_how(m, text);
    const size_t length = strcspn(name, "@");
    snprintf(m->name, sizeof m->name, "%.*s", (int)length, name);
    if (take_range(m, name + length) != 0)
        return measure_refuse(
            m, m->how == MEASURE_LAST
                   ? "expected one number after @, a time [s]"
                   : "expected @FROM or @FROM..TO after the name");
    if (measure_locate(m, s) != 0) return 2;
    const int in_time = strcmp(m->file, "history.csv") == 0 ||
                        strcmp(m->file, "probes.csv") == 0;
    if (in_time && (m->from < 0.0))
        return measure_refuse(m, "begins before 0 s, the start of the run");
    return in_time && m->from > s->output.end
               ? measure_refuse(m,
                                "begins after output.end, the end of the run")
               : 0;
}

/* --- the tables of a run --------------------------------------------------*/

static const char blanks[] = " \t\r";

/* The names of a head line, which lasts for `length` bytes. */
static void take_names(struct measure_table *t, const char *line, size_t length)
{
    const char *const end = line + length - (line[length - 1] == '\r');

    t->n_columns = 1;
    for (const char *p = line; p < end; p++)
        t->n_columns += *p == ',';
    t->name = alloc_zeroed((size_t)t->n_columns, sizeof *t->name);
    for (int i = 0; i < t->n_columns; i++) {
        const char *const comma = memchr(line, ',', (size_t)(end - line));
        const char *const stop = comma != NULL ? comma : end;
        t->name[i] = strndup(line, (size_t)(stop - line));
        line = stop + 1;
    }
}

/* One row of numbers, nan where a field is empty; 0 if the line is not one. */
static int take_row(struct measure_table *t, const char *line)
{
    double *const row = t->value + t->n_columns * t->n_rows;

    for (int i = 0; i < t->n_columns; i++) {
        const char *const ends = i + 1 < t->n_columns ? "," : "\n";
        char *end;

        line += strspn(line, blanks);
        row[i] = NAN;
        if (*line != '\0' && strchr(",\n", *line) == NULL) {
            row[i] = strtod(line, &end);
            if (end == line) return 0;
            line = end + strspn(end, blanks);
        }
        if (*line != *ends && !(*line == '\0' && *ends == '\n')) return 0;
        line++;
    }
    t->n_rows++;
    return 1;
}

/* Takes the head and the rows of a text; the number of the first line that is
 * none of them, or 0. */
static int take_lines(struct measure_table *t, const char *text)
{
    int lines = 1; /* the last may have no end */

    for (const char *at = text; (at = strchr(at, '\n')) != NULL; at++)
        lines++;
    for (int line = 1; line <= lines; line++) {
        const size_t length = strcspn(text, "\n");
        const char c = text[strspn(text, blanks)];
        const int counts = c != '#' && c != '\n' && c != '\0';

        if (counts && t->name == NULL) {
            take_names(t, text, length);
            t->value = alloc_doubles(t->n_columns * lines);
        } else if (counts && !take_row(t, text))
            return line;
        text += length + 1;
    }
    return 0;
}

struct measure_table *measure_table_read(const char *path, int *wrong)
{
    const char *why;
    size_t length;
    char *const text = input_text(path, &length, &why);
    struct measure_table *const t = alloc_zeroed(1, sizeof *t);
    char *const last = text != NULL ? strrchr(text, '\n') : NULL;

    if (last != NULL && wrong == NULL) last[1] = '\0';
    const int line = text != NULL ? take_lines(t, text) : 0;
    if (wrong != NULL) *wrong = text == NULL ? -1 : line;
    free(text);
    if (line == 0 && t->n_rows > 0) return t;
    measure_table_free(t);
    return NULL;
}

void measure_table_free(struct measure_table *t)
{
    if (t == NULL) return;
    for (int i = 0; i < t->n_columns; i++)
        free(t->name[i]);
    free(t->name);
    free(t->value);
    free(t);
}

/* The column of a name without its unit; of a probe, "us_y(0.1 0.2 0.3) [m/s]",
 * the name of the field will do. -1 if there is none. */
static int table_column(const struct measure_table *t, const char *name)
{
    const size_t n = strlen(name);

    for (int i = 0; i < t->n_columns; i++)
        if (strncmp(t->name[i], name, n) == 0 &&
            strchr(" (", t->name[i][n]) != NULL)
            return i;
    return -1;
}

void measure_unit(const struct measure *m, const char *folder, char unit[16])
{
    char *const path = file_join(folder, m->file);
    struct measure_table *const t = measure_table_read(path, NULL);
    const int column = t == NULL        ? -1
                       : m->column >= 0 ? m->column
                                        : table_column(t, m->name);
    const char *const at = column >= 0 && column < t->n_columns
                               ? strrchr(t->name[column], '[')
                               : NULL;

    snprintf(unit, 16, "%s", at != NULL ? at : "");
    measure_table_free(t);
    free(path);
}

/* --- what was found ------------------------------------------------------- */

static struct curve point(double x, double value, double error)
{
    struct curve c = curve_create(1);

    c.x[0] = x;
    c.value[0] = value;
    c.error[0] = error;
    return c;
}

/* The column with the standard error of a mean, "u_x_error" of "u_x_mean"; -1
 * if there is none. */
static int error_column(const struct measure_table *t, int column)
{
    const char *const name = t->name[column];
    const char *const end = strstr(name, "_mean ");
    char error[MEASURE_NAME];

    if (end == NULL) return -1;
    snprintf(error, sizeof error, "%.*s_error", (int)(end - name), name);
    return table_column(t, error);
}

/* Of a table in time the last row that was due; where the run ends it has one
 * more, sooner after that than those before are apart. */
static double last_due(const struct measure_table *t, double last)
{
    double at[3] = {last}; /* [s] the last three times; some have many rows */
    int n = 1;

    if (strncmp(t->name[0], "time ", 5) != 0) return last;
    for (int i = t->n_rows - 1; i >= 0 && n < 3; i--)
        if (t->value[i * t->n_columns] != at[n - 1])
            at[n++] = t->value[i * t->n_columns];
    return n == 3 && last - at[1] < (1.0 - 1e-6) * (at[1] - at[2]) ? at[1]
                                                                   : last;
}

/* The rows that count: first and last column, from .. to. In a mean each stands
 * for the time between two of them, and one that was not due for less. */
static struct curve measure_within(const struct measure *m,
                                   const struct measure_table *t, int column)
{
    const int error = error_column(t, column), mean = m->how == MEASURE_MEAN;
    const double last = t->value[(t->n_rows - 1) * t->n_columns];
    const double near = 1e-9 * fabs(last), due = last_due(t, last);
    const double from = isfinite(m->from) ? m->from
                        : mean            ? 0.5 * last
                                          : -INFINITY;
    const double end = mean && due >= from ? due : INFINITY;
    const double to = isfinite(m->to) ? fmin(m->to, end) : end;
    struct curve c = curve_create(t->n_rows);

    c.n = 0;
    for (int i = 0; i < t->n_rows; i++) {
        const double *const row = t->value + i * t->n_columns;
        if (row[0] < from - near || row[0] > to + near) continue;
        if (!isfinite(row[column])) continue; /* a cell that nobody was in */
        c.x[c.n] = row[0];
        if (error >= 0 && isfinite(row[error])) c.error[c.n] = row[error];
        c.value[c.n++] = row[column];
    }
    return c;
}

/* All rows as one number. */
static struct curve reduced(const struct measure *m, const struct curve *c)
{
    double best = c->value[0];
    int at = 0;

    if (m->how == MEASURE_MEAN)
        return point(NAN, moments_mean(c->n, c->value),
                     curve_block_error(c->n, c->value));
    if (m->how == MEASURE_LAST && isfinite(m->from)) {
        const int beyond = /* one row, of another time */
            c->n == 1 && fabs(m->from - c->x[0]) > 2e-9 * fabs(c->x[0]);
        return point(m->from, beyond ? NAN : curve_at(c, m->from, NULL), 0.0);
    }
    if (m->how == MEASURE_LAST)
        return point(c->x[c->n - 1], c->value[c->n - 1], 0.0);
    for (int i = 1; i < c->n; i++)
        if (m->how == MEASURE_MAX ? c->value[i] > best : c->value[i] < best)
            best = c->value[at = i];
    return point(c->x[at], best, 0.0);
}

static struct curve from_table(const struct measure *m,
                               const struct measure_table *t)
{
    const int column = m->column >= 0 ? m->column : table_column(t, m->name);
    struct measure all = *m;

    if (column < 0 || column >= t->n_columns) return (struct curve){0};
    if (m->how == MEASURE_LAST) all.from = NAN;
    struct curve c = measure_within(&all, t, column);
    if (c.n > 0 && m->how == MEASURE_CURVE) return c;
    const struct curve found = c.n > 0 ? reduced(m, &c) : (struct curve){0};
    curve_free(&c);
    return found;
}

struct curve measure_take(const struct measure *m, const char *folder)
{
    struct curve found = {0};

    if (strcmp(m->file, "summary.json") == 0) {
        const double value = read_summary_number(folder, m->name);
        return isfinite(value) ? point(NAN, value, 0.0) : found;
    }
    char *const path = file_join(folder, m->file);
    struct measure_table *const t = measure_table_read(path, NULL);
    if (t != NULL) found = from_table(m, t);
    measure_table_free(t);
    free(path);
    return found;
}
