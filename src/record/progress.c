/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/recorder.h"

#include "base/clock.h"
#include "base/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { BAR_LENGTH = 30 };

/* [s] between two drawings of the bar: often enough to be seen moving. */
static const double interval = 0.2;

static double share(const struct progress *p, double t)
{
    const double done = (t - p->first) / (p->end - p->first);
    return fmin(1.0, fmax(0.0, done));
}

/* 65 s as "1:05", 3725 s as "1:02:05". */
static void clock_text(double seconds, char text[32])
{
    const int all = number_clamped(seconds + 0.5, 0, 300000000);
    const int h = all / 3600, m = all / 60 % 60, s = all % 60;

    if (h > 0)
        snprintf(text, 32, "%d:%02d:%02d", h, m, s);
    else
        snprintf(text, 32, "%d:%02d", m, s);
}

void progress_line(const struct progress *p, double t, double elapsed,
                   char text[PROGRESS_TEXT])
{
    const double done = share(p, t);
    const int filled = number_clamped(done * BAR_LENGTH, 0, BAR_LENGTH);
    char bar[BAR_LENGTH + 1], left[32] = "?:??";

    memset(bar, '.', BAR_LENGTH);
    memset(bar, '#', (size_t)filled);
    bar[BAR_LENGTH] = '\0';
    if (done > 0.0) clock_text(elapsed * (1.0 - done) / done, left);
    snprintf(text, PROGRESS_TEXT, "%s%s%s%3.0f %%  t = %.4g of %.4g s, %s left",
             p->style == PROGRESS_BAR ? "[" : "",
             p->style == PROGRESS_BAR ? bar : "",
             p->style == PROGRESS_BAR ? "] " : "", floor(100.0 * done + 1e-9),
             t, p->end, left);
}

void progress_init(struct progress *p, double first, double end, int quiet)
{
    const int terminal = isatty(STDERR_FILENO);

    p->style = quiet      ? PROGRESS_QUIET
               : terminal ? PROGRESS_BAR
                          : PROGRESS_LINES;
    p->first = first;
    p->end = end;
    p->began = clock_now();
    p->drawn = p->began;
    p->tenths = 0;
}

void progress_show(struct progress *p, double t)
{
    const int tenths = number_clamped(10.0 * share(p, t) + 1e-9, 0, 10);
    const double now = p->style == PROGRESS_QUIET ? 0.0 : clock_now();
    /* Before the first tenth after 10 s, 20, 40, ... */
    const int early = tenths == 0 && now - p->began >= 10.0 &&
                      now - p->began >= 2.0 * (p->drawn - p->began);
    char text[PROGRESS_TEXT];

    if (p->style == PROGRESS_QUIET ||
        (p->style == PROGRESS_LINES && tenths <= p->tenths && !early) ||
        (p->style == PROGRESS_BAR && now - p->drawn < interval && t < p->end))
        return;
    p->tenths = tenths;
    p->drawn = now;
    progress_line(p, t, now - p->began, text);
    if (p->style == PROGRESS_BAR)
        fprintf(stderr, "\r%-78.78s", text);
    else
        fprintf(stderr, "%s\n", text);
}

void progress_end(struct progress *p)
{
    if (p->style == PROGRESS_BAR) fputc('\n', stderr);
}
