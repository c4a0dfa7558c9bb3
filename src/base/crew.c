/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/crew.h"

#include <omp.h>

#include "base/clock.h"

enum { TRIAL = 3 }; /* [-] steps */

/* Trials come soon at first, and as long as they change something; each that
 * does not doubles the rest until the next. Rests are counted in time, not in
 * steps: steps that became slow are looked into as soon as fast ones. */
static const double soon = 1.0, late = 128.0; /* [-] */

/* So much faster the others must be: what steps differ by anyway. */
static const double worth_it = 0.9; /* [-] */

static void measure(struct crew *c)
{
    c->measuring = 1;
    c->left = TRIAL;
    c->spent = 0.0;
}

void crew_init(struct crew *c, int most)
{
    *c = (struct crew){
        .most = most, .now = 1, .target = most, .rest = 0.5 * soon};
    measure(c);
}

/* More and fewer by turns. */
static void begin_trial(struct crew *c)
{
    c->known = c->spent;
    c->up = c->now == 1 || (!c->up && c->now < c->most);
    c->tried = c->up ? c->target : c->now / 2;
    c->measuring = 0;
    c->left = TRIAL;
    c->spent = 0.0;
}

/* A trial that takes longer than what it is held against ends early. After one
 * with more threads in vain, half of them are tried next. */
static void end_trial(struct crew *c)
{
    const int better = c->left == 0 && c->spent < worth_it * c->known;

    if (better) {
        c->now = c->tried;
        c->known = c->spent;
    }
    if (c->up) c->target = better ? c->most : c->target / 2;
    if (c->target <= c->now) c->target = c->most;
    c->rest = better ? soon : 2.0 * c->rest < late ? 2.0 * c->rest : late;
    c->tried = 0;
    c->spent = 0.0;
}

int crew_next(struct crew *c, double seconds)
{
    if (c->most == 1) return 1;
    c->spent += seconds;
    c->left--;
    if (c->tried > 0) {
        if (c->left == 0 || c->spent > c->known) end_trial(c);
    } else if (c->measuring) {
        if (c->left == 0) begin_trial(c);
    } else if (c->spent >= c->rest * c->known) {
        measure(c);
    }
    return c->tried > 0 ? c->tried : c->now;
}

/* Whoever has one thread pays nothing, not even a look at the clock. */
void crew_gather(struct crew *c)
{
    crew_init(c, omp_get_max_threads());
    omp_set_num_threads(1);
}

void crew_begin(struct crew *c)
{
    if (c->most > 1) c->begin = clock_now();
}

void crew_end(struct crew *c)
{
    if (c->most > 1) omp_set_num_threads(crew_next(c, clock_now() - c->begin));
}

void crew_dismiss(const struct crew *c)
{
    omp_set_num_threads(c->most);
}
