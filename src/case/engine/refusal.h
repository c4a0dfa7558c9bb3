/* refusal.h -- what the distributed engine cannot compute, and why.
 * Chapter "Past one machine".
 *
 * LAMMPS ends the whole program at a word that it does not know, so a case is
 * looked at before. Keys are listed that the engine knows: one that is not, as
 * a new model will have, is refused by itself.
 */
#ifndef CASE_ENGINE_REFUSAL_H
#define CASE_ENGINE_REFUSAL_H

#include "case/settings.h"

/* 0; or 2 after a message that names the key: of the engine, and of the export,
 * which needs only what LAMMPS does. */
int refusal_engine(const struct settings *s);
int refusal_export(const struct settings *s);

#endif
