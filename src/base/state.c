/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/state.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

enum { STATE_MAX_SEVERAL = 32 };

void state_begin(struct state *s, const char *part)
{
    const size_t used = strlen(s->path);

    assert(used + strlen(part) + 2 < sizeof s->path);
    snprintf(s->path + used, sizeof s->path - used, "/%s", part);
}

void state_begin_number(struct state *s, const char *part, int number)
{
    char name[64];

    snprintf(name, sizeof name, "%s%d", part, number);
    state_begin(s, name);
}

void state_end(struct state *s)
{
    char *const last = strrchr(s->path, '/');

    assert(last != NULL);
    *last = '\0';
}

static void state_visit(struct state *s, const char *name, struct state_array a)
{
    if (s->failed || a.values == NULL || a.rows == 0) return;
    state_begin(s, name);
    a.path = s->path;
    s->failed = s->visit(s->store, &a) != 0;
    state_end(s);
}

void state_reals(struct state *s, const char *name, const char *unit, double *x,
                 long n, int width)
{
    state_visit(s, name,
                (struct state_array){NULL, unit, STATE_REAL, x, n, width});
}

void state_wholes(struct state *s, const char *name, const char *unit, int *x,
                  long n, int width)
{
    state_visit(s, name,
                (struct state_array){NULL, unit, STATE_WHOLE, x, n, width});
}

/* Visits a copy in which the members lie side by side. */
static void visit_members(struct state *s, const char *name,
                          struct state_array a, size_t row, size_t stride)
{
    if (s->failed || a.values == NULL || a.rows == 0) return;
    char *const x = a.values, *const copy = alloc_zeroed((size_t)a.rows, row);

    a.values = copy;
    for (long i = 0; i < a.rows && !s->loading; i++)
        memcpy(copy + (size_t)i * row, x + (size_t)i * stride, row);
    state_visit(s, name, a);
    for (long i = 0; i < a.rows && s->loading && !s->failed; i++)
        memcpy(x + (size_t)i * stride, copy + (size_t)i * row, row);
    free(copy);
}

void state_reals_of(struct state *s, const char *name, const char *unit,
                    double *x, size_t stride, long n, int width)
{
    visit_members(s, name,
                  (struct state_array){NULL, unit, STATE_REAL, x, n, width},
                  (size_t)width * sizeof *x, stride);
}

void state_wholes_of(struct state *s, const char *name, const char *unit,
                     int *x, size_t stride, long n, int width)
{
    visit_members(s, name,
                  (struct state_array){NULL, unit, STATE_WHOLE, x, n, width},
                  (size_t)width * sizeof *x, stride);
}

void state_real(struct state *s, const char *name, const char *unit, double *x)
{
    state_reals(s, name, unit, x, 1, 1);
}

void state_whole(struct state *s, const char *name, const char *unit, int *x)
{
    state_wholes(s, name, unit, x, 1, 1);
}

void state_long(struct state *s, const char *name, const char *unit, long *x)
{
    state_visit(s, name, (struct state_array){NULL, unit, STATE_LONG, x, 1, 1});
}

void state_several(struct state *s, const char *name, const char *unit,
                   double *const x[], int n)
{
    double all[STATE_MAX_SEVERAL];

    assert(n <= STATE_MAX_SEVERAL);
    for (int k = 0; k < n; k++)
        all[k] = *x[k];
    state_reals(s, name, unit, all, n, 1);
    for (int k = 0; k < n; k++)
        *x[k] = all[k];
}

/* The bytes of a file are those that were written (state_file.h). */
int state_wrong(const struct state *s, const char *format, ...)
{
    char message[2 * STATE_PATH];
    va_list values;

    va_start(values, format);
    vsnprintf(message, sizeof message, format, values);
    va_end(values);
    if (s->file == NULL)
        fprintf(stderr, "winnow: the state: %s\n", message);
    else
        fprintf(stderr,
                "winnow: %s: %s; another version of the program, or another "
                "case, wrote it: %s\n",
                s->file, message, s->remedy);
    return 1;
}

static void state_refuse(struct state *s, const char *name, long value,
                         long least, long most)
{
    s->failed = state_wrong(s, "%s/%s = %ld; expected %ld to %ld", s->path,
                            name, value, least, most);
}

void state_count(struct state *s, const char *name, int *n, int max)
{
    int now = *n;

    state_whole(s, name, "-", &now);
    if (s->loading && s->most > 0 && max > s->most) max = (int)s->most;
    if (!s->failed && (now < 0 || now > max))
        state_refuse(s, name, now, 0, max);
    if (!s->failed) *n = now;
}

void state_indices(struct state *s, const char *name, int *x, long n, int least,
                   int most)
{
    state_indices_of(s, name, x, sizeof *x, n, least, most);
}

void state_indices_of(struct state *s, const char *name, int *x, size_t stride,
                      long n, int least, int most)
{
    state_wholes_of(s, name, "-", x, stride, n, 1);
    for (long i = 0; i < n && x != NULL && s->loading && !s->failed; i++) {
        const int value = *(int *)((char *)x + (size_t)i * stride);
        if (value < least || value > most)
            state_refuse(s, name, value, least, most);
    }
}

void state_demand(struct state *s, int holds, const char *what)
{
    if (s->loading && !s->failed && !holds)
        s->failed = state_wrong(s, "%s has %s", s->path, what);
}

int state_rises(const int *x, long n, int first, int last)
{
    for (long i = 1; i < n; i++)
        if (x[i] < x[i - 1]) return 0;
    return n == 0 || (x[0] == first && x[n - 1] == last);
}
