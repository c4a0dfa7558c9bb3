/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/surfaces/case_surfaces.h"

#include <stddef.h>

/* As in keys.c. The last seven of a surface and of a prescribed particle say
 * how it moves. */
const struct key case_surfaces_keys[] = {
    {"particles.surfaces", KEY_LIST, "", "", "",
     "walls besides those of the box", "LS section 4.3", ""},
    {"particles.surfaces.name", KEY_TEXT, "", "", NULL,
     "its name in messages and in surfaces.csv", "", ""},
    {"particles.surfaces.shape", KEY_NAME, "", "", NULL, "its shape", "", ""},
    {"particles.surfaces.material", KEY_TEXT, "", "", "",
     "its material, a name in particles.materials; left out: grains", "", ""},
    {"particles.surfaces.velocity", KEY_VECTOR, "m/s", "", "[0.0, 0.0, 0.0]",
     "constant velocity", "", ""},
    {"particles.surfaces.amplitude", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "amplitude of an oscillation, which begins at its middle", "", ""},
    {"particles.surfaces.frequency", KEY_REAL, "Hz", ">= 0", "0.0",
     "frequency of the oscillation", "", ""},
    {"particles.surfaces.centre", KEY_VECTOR, "m", "", "",
     "a point of the axis of rotation, at time 0; torques are about it; left "
     "out: point",
     "", ""},
    {"particles.surfaces.spin", KEY_VECTOR, "rad/s", "", "[0.0, 0.0, 0.0]",
     "angular velocity about that axis", "", ""},
    {"particles.surfaces.from", KEY_REAL, "s", ">= 0", "0.0",
     "start of the motion", "", ""},
    {"particles.surfaces.until", KEY_REAL, "s", "> 0", "",
     "end of the motion; left out: that of the run", "", ""},

    {"particles.prescribed", KEY_LIST, "", "", "",
     "single particles with a prescribed motion", "LS Fig. 4.3", ""},
    {"particles.prescribed.id", KEY_INT, "-", ">= 0", NULL,
     "number of the particle, in the order of creation, from 0", "", ""},
    {"particles.prescribed.velocity", KEY_VECTOR, "m/s", "", "[0.0, 0.0, 0.0]",
     "constant velocity", "", ""},
    {"particles.prescribed.amplitude", KEY_VECTOR, "m", "", "[0.0, 0.0, 0.0]",
     "amplitude of an oscillation, which begins at its middle", "", ""},
    {"particles.prescribed.frequency", KEY_REAL, "Hz", ">= 0", "0.0",
     "frequency of the oscillation", "", ""},
    {"particles.prescribed.centre", KEY_VECTOR, "m", "", "",
     "a point of the axis of rotation; needed by spin", "", ""},
    {"particles.prescribed.spin", KEY_VECTOR, "rad/s", "", "[0.0, 0.0, 0.0]",
     "angular velocity about that axis, and its own", "", ""},
    {"particles.prescribed.from", KEY_REAL, "s", ">= 0", "0.0",
     "start of the prescribed motion; before it the particle is free", "", ""},
    {"particles.prescribed.until", KEY_REAL, "s", "> 0", "",
     "end of the motion; left out: that of the run", "", ""},
    KEY_END};
