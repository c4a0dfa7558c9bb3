/* SPDX-License-Identifier: GPL-3.0-or-later */
/* output_keys.c -- the keys of the group `output` that every run has, and the
 * members of struct output_options that they fill. */
#include "output/output_options.h"

const struct key output_keys[] = {
    {"output", KEY_GROUP, "", "", NULL, "how long to run and what to write", "",
     "", .mark = KEY_AFTER_BED},
    {"output.end", KEY_REAL, "s", "> 0", NULL,
     "simulated time at which the run ends", "", "",
     .at = KEY_AT(output_options, end), .mark = KEY_MAY_CHANGE},
    {"output.every", KEY_REAL, "s", "> 0", NULL,
     "time between two pictures of all fields and particles", "", "",
     .at = KEY_AT(output_options, every), .mark = KEY_MAY_CHANGE},
    {"output.checkpoint", KEY_REAL, "s", "> 0", "600.0",
     "wall time between two checkpoints, from which --resume continues", "", "",
     .at = KEY_AT(output_options, checkpoint), .mark = KEY_MAY_CHANGE},
    {"output.history", KEY_REAL, "s", "> 0", "",
     "time between two rows of history.csv; left out: every fluid step", "", "",
     .at = KEY_AT(output_options, history), .mark = KEY_MAY_CHANGE},
    KEY_END};
