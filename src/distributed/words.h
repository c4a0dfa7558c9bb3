/* words.h -- the particles of a case in the words of LAMMPS.
 * Chapter "Past one machine".
 *
 * The contact law is told in numbers: pair style granular with Hertz's normal
 * force, Mindlin's tangential spring and Tsuji's dashpot is our law up to the
 * order of delta / R, and likewise with linear springs. Tsuji's dashpot is
 * alpha(e') sqrt(m* k), with a polynomial alpha; e' is the number for which it
 * has our damping ratio.
 */
#ifndef DISTRIBUTED_WORDS_H
#define DISTRIBUTED_WORDS_H

#include "case/settings.h"
#include "dem/contact.h"

enum { WORDS_MATERIALS = 16, WORDS_LINE = 1024 };

struct words {
    double lo[3], hi[3]; /* [m] */
    int periodic[3];     /* [-] 1: no walls */
    double step, skin;   /* [s], [m] */
    int hertz;           /* [-] 1: Hertz's law, 0: linear springs */
    int starts;          /* [-] of LAMMPS before the first step */
    int materials;       /* [-] number of them; one type each */
    int wall;            /* [-] material of the walls */
    struct contact_constants pair[WORDS_MATERIALS * WORDS_MATERIALS];
};

/* Takes one line, without its end. */
typedef void words_tell(void *to, const char *line);

/* 1 if LAMMPS has the contact law of the case. */
int words_has_law(const struct settings *s);

/* What the case says; d [m] is the mean diameter, of which the list of
 * neighbours is wider by a sixth where the case does not say how much. */
struct words words_of(const struct settings *s, double d);

/* e' of a damping ratio of Hertz's law or of a linear spring; negative: none
 * [-]. */
double words_restitution(int hertz, double zeta);

/* What comes before the box, the box itself, and what comes after the
 * particles are there: contacts, walls, motion. */
void words_begin(const struct words *w, words_tell *tell, void *to);
void words_box(const struct words *w, words_tell *tell, void *to);
void words_contacts(const struct words *w, words_tell *tell, void *to);

/* Takes the walls away again. */
void words_no_walls(const struct words *w, words_tell *tell, void *to);

#endif
