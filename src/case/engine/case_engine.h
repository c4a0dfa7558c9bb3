/* case_engine.h -- whether one machine or several compute a case.
 * Chapter "Past one machine". */
#ifndef CASE_ENGINE_CASE_ENGINE_H
#define CASE_ENGINE_CASE_ENGINE_H

#include "case/settings.h"

struct case_scales;

extern const struct key case_engine_keys[];

/* Whether the distributed engine can compute the case: 0, or 2 after a message;
 * case_engine_check: 0 also where the case does not ask for it. LAMMPS ends the
 * whole program at a word that it does not know, so a case is looked at before.
 */
int case_engine_check_all(const struct settings *s);
int case_engine_check(const struct settings *s);

/* Prints its lines for `winnow check`. */
void case_engine_print(const struct settings *s, const struct case_scales *k);

/* Whether this program can compute the case: 0, or 2 after a message. */
int case_engine_check_run(const struct settings *s);

/* What the export, which needs only what LAMMPS does, cannot tell it: 0, or 2
 * after a message that names the key. */
int case_engine_check_export(const struct settings *s);

#endif
