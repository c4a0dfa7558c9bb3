/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/contact_loops.h"

#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"
#include "dem/fast/contact_sweep.h"

#define LOOP(name, options, respond)                                           \
    static void name##_##options(struct chunk *s, const struct bodies *b,      \
                                 const struct contact_constants *k, double dt, \
                                 int first, int last)                          \
    {                                                                          \
        sweep_contacts(s, b, k, dt, first, last, respond, options);            \
    }
#define LOOPS(name, respond)                                                   \
    LOOP(name, 0, respond)                                                     \
    LOOP(name, 1, respond)                                                     \
    LOOP(name, 2, respond)                                                     \
    LOOP(name, 3, respond)                                                     \
    LOOP(name, 6, respond)                                                     \
    LOOP(name, 7, respond)                                                     \
    LOOP(name, 10, respond)                                                    \
    LOOP(name, 11, respond)                                                    \
    LOOP(name, 14, respond)                                                    \
    LOOP(name, 15, respond)
#define TABLE(name)                                                            \
    {                                                                          \
        name##_0, name##_1, name##_2, name##_3, NULL, NULL, name##_6,          \
            name##_7, NULL, NULL, name##_10, name##_11, NULL, NULL, name##_14, \
            name##_15                                                          \
    }

LOOPS(hertz, contact_hertz_respond)
LOOPS(linear, contact_linear_respond)
LOOPS(any, b->law->respond)

static const struct {
    const struct contact_law *law;
    contact_sweep *sweep[CONTACT_LOOPS];
} loops[] = {{&contact_hertz, TABLE(hertz)},
             {&contact_linear, TABLE(linear)},
             {NULL, TABLE(any)}}; /* the last is for all others */

contact_sweep *contact_loops_of(const struct contact_law *law, int options)
{
    int k = 0;

    while (loops[k].law != NULL && loops[k].law != law)
        k++;
    return loops[k].sweep[options];
}
