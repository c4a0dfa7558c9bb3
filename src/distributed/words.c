/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distributed/words.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case/build.h"
#include "case/particles/case_materials.h"
#include "case/case_file.h"
#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"

int words_has_law(const struct settings *s)
{
    const struct contact_law *const law = s->particles.contact;
    return law == &contact_hertz || law == &contact_linear;
}

struct words words_of(const struct settings *s, double d)
{
    const double step = case_steps_length(s) / case_steps_within(s);
    const struct dem_options o = build_particles_dem(s, step);
    struct materials *const all = case_materials_create(s);
    struct words w = {.step = step,
                      .skin = o.skin > 0.0 ? o.skin : d / 6.0,
                      .starts = 1,
                      .hertz = o.law == &contact_hertz,
                      .materials = materials_count(all),
                      .wall = all != NULL ? all->wall : 0};

    memcpy(w.lo, o.lo, sizeof w.lo);
    memcpy(w.hi, o.hi, sizeof w.hi);
    memcpy(w.periodic, o.periodic, sizeof w.periodic);
    if (w.materials <= WORDS_MATERIALS)
        materials_table(o.law, &o.material, all, w.pair);
    free(all);
    return w;
}

/* alpha(e'), as LAMMPS computes it [-]; it falls from 1.27 at 0 to 0 at 1. */
static double tsuji(double e)
{
    return 1.2728 +
           e * (-4.2783 +
                e * (11.087 + e * (-22.348 +
                                   e * (27.467 + e * (-18.022 + e * 4.8218)))));
}

/* The number for which alpha(e) has this value. Our dashpots are sqrt(5) zeta
 * sqrt(m* k) with Hertz's k = (4/3) E* a, and 2 zeta sqrt(m* k) with a linear
 * spring. */
static double root(double alpha)
{
    double lo = 0.0, hi = 1.0;

    for (int i = 0; i < 200; i++) {
        const double e = 0.5 * (lo + hi);
        if (tsuji(e) > alpha)
            lo = e;
        else
            hi = e;
    }
    return 0.5 * (lo + hi);
}

double words_restitution(int hertz, double zeta)
{
    const double alpha = (hertz ? sqrt(5.0) : 2.0) * zeta;

    return alpha > tsuji(0.0) ? -1.0 : root(alpha);
}

static void say(words_tell *tell, void *to, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static void say(words_tell *tell, void *to, const char *format, ...)
{
    char line[WORDS_LINE];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    tell(to, line);
}

void words_begin(const struct words *w, words_tell *tell, void *to)
{
    say(tell, to, "units si");
    say(tell, to, "atom_style sphere");
    say(tell, to, "boundary %c %c %c", w->periodic[0] ? 'p' : 'f',
        w->periodic[1] ? 'p' : 'f', w->periodic[2] ? 'p' : 'f');
    say(tell, to, "newton off");
    say(tell, to, "comm_modify vel yes");
}

void words_box(const struct words *w, words_tell *tell, void *to)
{
    say(tell, to, "region box block %.17g %.17g %.17g %.17g %.17g %.17g",
        w->lo[0], w->hi[0], w->lo[1], w->hi[1], w->lo[2], w->hi[2]);
    say(tell, to, "create_box %d box", w->materials);
}

/* The contact of materials a and b: normal, tangential, damping. LAMMPS of 2021
 * replaces e' of a wall by alpha(e') each time it starts, `starts` times before
 * the first step. */
static void contact(const struct words *w, int a, int b, int starts,
                    char text[WORDS_LINE])
{
    const struct contact_constants *const k = &w->pair[a * w->materials + b];
    double e = words_restitution(w->hertz, k->damping_n);

    for (int i = 1; i < starts; i++)
        e = root(e);

    snprintf(text, WORDS_LINE,
             "%s %.17g %.17g tangential %s %.17g %.17g %.17g damping tsuji",
             w->hertz ? "hertz" : "hooke",
             w->hertz ? 4.0 / 3.0 * k->normal : k->normal, e,
             w->hertz ? "mindlin" : "linear_history",
             w->hertz ? 8.0 * k->tangential : k->tangential, k->damping_t,
             k->friction);
}

static void walls(const struct words *w, int a, words_tell *tell, void *to)
{
    char text[WORDS_LINE];

    contact(w, a, w->wall, w->starts, text);
    for (int k = 0; k < 3; k++)
        if (!w->periodic[k])
            say(tell, to,
                "fix wall_%c_%d type_%d wall/gran granular %s %cplane %.17g "
                "%.17g",
                'x' + k, a + 1, a + 1, text, 'x' + k, w->lo[k], w->hi[k]);
}

void words_no_walls(const struct words *w, words_tell *tell, void *to)
{
    for (int a = 0; a < w->materials; a++) {
        for (int k = 0; k < 3; k++)
            if (!w->periodic[k])
                say(tell, to, "unfix wall_%c_%d", 'x' + k, a + 1);
        say(tell, to, "group type_%d delete", a + 1);
    }
}

void words_contacts(const struct words *w, words_tell *tell, void *to)
{
    char text[WORDS_LINE];

    say(tell, to, "neighbor %.17g bin", w->skin);
    say(tell, to, "neigh_modify delay 0 every 1 check yes");
    say(tell, to, "pair_style granular");
    for (int a = 0; a < w->materials; a++)
        for (int b = a; b < w->materials; b++) {
            contact(w, a, b, 1, text);
            say(tell, to, "pair_coeff %d %d %s", a + 1, b + 1, text);
        }
    for (int a = 0; a < w->materials; a++)
        say(tell, to, "group type_%d type %d", a + 1, a + 1);
    for (int a = 0; a < w->materials; a++)
        walls(w, a, tell, to);
    say(tell, to, "timestep %.17g", w->step);
    say(tell, to, "thermo_modify lost ignore");
}
