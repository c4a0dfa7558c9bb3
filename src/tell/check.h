/* check.h -- `winnow check`: a case in derived numbers, before it is run. */
#ifndef TELL_CHECK_H
#define TELL_CHECK_H

#include "case/checks/case_scales.h"
#include "coupling/effect_scales.h"

struct command_line;
struct effect;

/* Solids fraction of a packed bed, where the interstitial velocity is largest
 * [-]. */
#define CHECK_PACKED 0.6

/* Prints on stdout what follows from the case: resolution, time scales, chosen
 * steps, cost. Returns the exit code, 0 or 2. */
int check_case(const struct settings *s);

/* Its sections: the Courant number of the flow as it enters; the bandwidth
 * beside cells, particles and bed; relaxation times and what a bed asks for;
 * attractions; every effect, named or not, and how the phases should be
 * coupled; the next finer and the next coarser choices. */
void check_flow(const struct settings *s, const struct case_scales *k);
/* The Courant number of that flow, 0 if nothing is known to move. */
double check_courant(const struct settings *s, const struct case_scales *k);
void check_averaging(const struct settings *s, const struct case_scales *k);
void check_drag(const struct settings *s, const struct case_scales *k);
void check_cohesion(const struct settings *s, const struct case_scales *k);
void check_effects(const struct settings *s, const struct case_scales *k);
void check_accuracy(const struct settings *s, const struct case_scales *k);

/* The scales from which the effects estimate themselves. */
struct effect_scales check_scales(const struct settings *s,
                                  const struct case_scales *in);

/* `winnow check CASE --try SECONDS`: runs the case so long with all effects
 * that could matter, then without each of them. Returns the exit code. */
int check_try(const struct command_line *l);

/* What is said of an effect. */
enum { CHECK_EFFECTS = 32 };
struct effect_row {
    const struct effect *effect;
    const struct effect *instead; /* stands for it; or NULL */
    int named;                    /* [-] 1: it is on */
    double time;                  /* [-] of the run without it */
    struct effect_estimate estimate;
};

/* In words: needed, negligible or unknown. */
enum { CHECK_VERDICT = 256 };
void check_verdict(const struct effect_row *r, char text[CHECK_VERDICT]);

/* Fills the rows of all effects that the case has or could have; how many. */
int check_effect_rows(const struct settings *s, struct effect_scales *k,
                      const struct case_scales *in,
                      struct effect_row row[CHECK_EFFECTS]);

#endif
