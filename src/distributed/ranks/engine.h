/* engine.h -- what the first rank asks of all ranks.
 * Chapter "Past one machine".
 *
 * The first rank runs the program as on one machine, with its part as the
 * simulation. Where that starts, steps, is looked at, written or saved, it asks
 * all ranks to do so with their parts. The others wait for what they are asked.
 */
#ifndef DISTRIBUTED_RANKS_ENGINE_H
#define DISTRIBUTED_RANKS_ENGINE_H

#include "record/recorder_part.h"
#include "coupling/processes.h"

extern const struct recorder_part engine_summary;

/* Serves until the first rank stops; returns its exit code. The words are those
 * of the command line. */
int engine_serve(int argc, char **argv);

/* Called by the first rank at its end. */
void engine_stop(int code);

#endif
