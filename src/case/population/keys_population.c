/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/population/case_population.h"

#include <stddef.h>

/* As in keys.c. */
const struct key case_population_keys[] = {
    {"particles.bed.sizes", KEY_TEXT, "", "", "",
     "or the name of one of particles.sizes", "XS11 section 4.4", ""},
    {"particles.bed.file", KEY_FILE, "", "", "",
     "the settled bed: read if it exists, else written for the next run; "
     "beside the case unless it begins with /",
     "", ""},
    {"particles.sizes", KEY_LIST, "", "", "",
     "distributions of diameters, for others to name", "XS11 section 4.4", ""},
    {"particles.sizes.name", KEY_TEXT, "", "", NULL, "what others call it", "",
     ""},
    {"particles.sizes.distribution", KEY_NAME, "", "", NULL, "its kind",
     "XS11 section 4.4", ""},
    {"particles.insert", KEY_LIST, "", "", "",
     "sources: particles that come in, at random places where nobody is", "",
     ""},
    {"particles.insert.count", KEY_INT, "-", ">= 1", "",
     "how many will come; left out with a file", "", ""},
    {"particles.insert.rate", KEY_REAL, "1/s", "> 0", "",
     "how many a second; left out: all at once", "", ""},
    {"particles.insert.start", KEY_REAL, "s", ">= 0", "0.0",
     "time of the first", "", ""},
    {"particles.insert.from", KEY_VECTOR, "m", "", "",
     "lower corner of their region; left out: the box", "", ""},
    {"particles.insert.to", KEY_VECTOR, "m", "", "",
     "upper corner of their region; left out: the box", "", ""},
    {"particles.insert.velocity", KEY_VECTOR, "m/s", "", "[0.0, 0.0, 0.0]",
     "velocity that they come with", "", ""},
    {"particles.insert.diameter", KEY_REAL, "m", "> 0", "",
     "their diameter, where all are equal", "", ""},
    {"particles.insert.sizes", KEY_TEXT, "", "", "",
     "or the name of one of particles.sizes", "", ""},
    {"particles.insert.material", KEY_TEXT, "", "", "",
     "its name; left out: grains", "", ""},
    {"particles.insert.seed", KEY_INT, "-", ">= 0", "1",
     "seed of sizes and places", "", ""},
    {"particles.insert.file", KEY_FILE, "", "", "",
     "instead of chance: a file with x y z d [m] in each line, a table with "
     "names of columns, or a dump or a data file of LAMMPS or LIGGGHTS; "
     "beside the case unless "
     "it begins with /",
     "", ""},
    {"particles.sinks", KEY_LIST, "", "", "",
     "where particles leave: a side of the box, or a region", "", ""},
    {"particles.sinks.side", KEY_NAME, "",
     "none | left | right | bottom | top | back | front", "none",
     "they leave before they touch this side", "", ""},
    {"particles.sinks.from", KEY_VECTOR, "m", "", "",
     "lower corner of the region", "", ""},
    {"particles.sinks.to", KEY_VECTOR, "m", "", "",
     "upper corner of the region", "", ""},
    {"particles.overlaps", KEY_NAME, "", "refuse | relax | allow", "refuse",
     "what becomes of placed spheres that are in each other by over 1 %", "",
     ""},
    KEY_END};
