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
     "named distributions of diameters", "XS11 section 4.4", ""},
    {"particles.sizes.name", KEY_TEXT, "", "", NULL, "its name", "", ""},
    {"particles.sizes.distribution", KEY_NAME, "", "", NULL, "its distribution",
     "XS11 section 4.4", ""},
    {"particles.insert", KEY_LIST, "", "", "",
     "sources: particles inserted at random free places", "", ""},
    {"particles.insert.count", KEY_INT, "-", ">= 1", "",
     "number of particles to insert; left out with a file", "", ""},
    {"particles.insert.rate", KEY_REAL, "1/s", "> 0", "",
     "particles per second; left out: all at once", "", ""},
    {"particles.insert.start", KEY_REAL, "s", ">= 0", "0.0",
     "time of the first", "", ""},
    {"particles.insert.from", KEY_VECTOR, "m", "", "",
     "lower corner of their region; left out: the box", "", ""},
    {"particles.insert.to", KEY_VECTOR, "m", "", "",
     "upper corner of their region; left out: the box", "", ""},
    {"particles.insert.velocity", KEY_VECTOR, "m/s", "", "[0.0, 0.0, 0.0]",
     "their velocity at insertion", "", ""},
    {"particles.insert.diameter", KEY_REAL, "m", "> 0", "",
     "their diameter, where all are equal", "", ""},
    {"particles.insert.sizes", KEY_TEXT, "", "", "",
     "or the name of one of particles.sizes", "", ""},
    {"particles.insert.material", KEY_TEXT, "", "", "",
     "its name; left out: grains", "", ""},
    {"particles.insert.seed", KEY_INT, "-", ">= 0", "1",
     "seed of sizes and places", "", ""},
    {"particles.insert.file", KEY_FILE, "", "", "",
     "instead of random places: a file with x y z d [m] in each line, a table "
     "with names of columns, or a dump or a data file of LAMMPS or LIGGGHTS; "
     "beside the case unless it begins with /",
     "", ""},
    {"particles.insert.offset", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "added to the places of the file; one that is then outside a periodic "
     "direction is brought back",
     "", ""},
    {"particles.sinks", KEY_LIST, "", "", "",
     "sinks: where particles are removed, a side of the box or a region", "",
     ""},
    {"particles.sinks.side", KEY_NAME, "",
     "none | left | right | bottom | top | back | front", "none",
     "particles are removed before they touch this side", "", ""},
    {"particles.sinks.from", KEY_VECTOR, "m", "", "",
     "lower corner of the region", "", ""},
    {"particles.sinks.to", KEY_VECTOR, "m", "", "",
     "upper corner of the region", "", ""},
    {"particles.overlaps", KEY_NAME, "", "refuse | relax | allow", "refuse",
     "what is done about placed spheres that overlap by more than 1 %", "", ""},
    KEY_END};
