/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/surfaces/case_surfaces.h"

#include <stddef.h>

/* As in keys.c. The last seven of a surface and of a prescribed particle say
 * how it moves. */
const struct key case_surfaces_keys[] = {
    {"particles.surfaces", KEY_LIST, "", "", "",
     "walls besides those of the box", "LS section 4.3", ""},
    {"particles.surfaces.name", KEY_TEXT, "", "", NULL,
     "what messages and surfaces.csv call it", "", ""},
    {"particles.surfaces.shape", KEY_NAME, "", "", NULL,
     "a plane with its solid behind, a cylinder without ends, or triangles", "",
     ""},
    {"particles.surfaces.material", KEY_TEXT, "", "", "",
     "what it is made of: grains if left out, or a name in "
     "particles.materials",
     "", ""},
    {"particles.surfaces.velocity", KEY_VECTOR, "m/s", "", "[0.0, 0.0, 0.0]",
     "constant velocity", "", ""},
    {"particles.surfaces.amplitude", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "of an oscillation, from the middle on", "", ""},
    {"particles.surfaces.frequency", KEY_REAL, "Hz", ">= 0", "0.0",
     "of the oscillation", "", ""},
    {"particles.surfaces.centre", KEY_VECTOR, "m", "", "",
     "a point of the axis of rotation, at time 0; torques are about it; left "
     "out: point",
     "", ""},
    {"particles.surfaces.spin", KEY_VECTOR, "rad/s", "", "[0.0, 0.0, 0.0]",
     "rotation about that axis", "", ""},
    {"particles.surfaces.from", KEY_REAL, "s", ">= 0", "0.0",
     "it moves from this time on", "", ""},
    {"particles.surfaces.until", KEY_REAL, "s", "> 0", "",
     "and no longer; left out: to the end", "", ""},

    {"particles.prescribed", KEY_LIST, "", "", "",
     "single particles that move as prescribed, whatever pushes them",
     "LS Fig. 4.3", ""},
    {"particles.prescribed.id", KEY_INT, "-", ">= 0", NULL,
     "number of the particle, in the order of creation, from 0", "", ""},
    {"particles.prescribed.velocity", KEY_VECTOR, "m/s", "", "[0.0, 0.0, 0.0]",
     "constant velocity", "", ""},
    {"particles.prescribed.amplitude", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "of an oscillation, from the middle on", "", ""},
    {"particles.prescribed.frequency", KEY_REAL, "Hz", ">= 0", "0.0",
     "of the oscillation", "", ""},
    {"particles.prescribed.centre", KEY_VECTOR, "m", "", "",
     "a point of the axis that it circles about; asked for by spin", "", ""},
    {"particles.prescribed.spin", KEY_VECTOR, "rad/s", "", "[0.0, 0.0, 0.0]",
     "its circling about that axis, and its own rotation", "", ""},
    {"particles.prescribed.from", KEY_REAL, "s", ">= 0", "0.0",
     "it is driven from this time on, and free before", "", ""},
    {"particles.prescribed.until", KEY_REAL, "s", "> 0", "",
     "and no longer; left out: to the end", "", ""},
    KEY_END};
