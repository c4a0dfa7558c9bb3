/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bodies_setup.c -- the keys of the group `bodies`, and the members of struct
 * bodies_setup that they fill. */
#include "resolved/bodies_setup.h"

#include "base/model.h"

static const struct model is_free = {.name = "free", .value = BODY_FREE},
                          is_fixed = {.name = "fixed", .value = BODY_FIXED},
                          is_prescribed = {.name = "prescribed",
                                           .value = BODY_PRESCRIBED},
                          is_on_spring = {.name = "spring",
                                          .value = BODY_SPRING};
static const struct model *const motions[] = {
    &is_free, &is_fixed, &is_prescribed, &is_on_spring, NULL};

#define AT(member) KEY_AT(bodies_setup, member)
#define OF(member) KEY_AT(body_setup, member)
#define LIST_OF(number) AT(list[number]), .size = sizeof(struct body_setup)

/* What rows of several lists have in common, after their paths. */
#define ZERO "[0.0, 0.0, 0.0]"
#define POSITION(what) KEY_VECTOR, "m", "", NULL, what, "", "", OF(position)
#define DIAMETER KEY_REAL, "m", "> 0", NULL, "diameter", "", "", OF(diameter)
#define SCALE(what) KEY_REAL, "-", "> 0", "1.0", what, "", "", OF(scale)
#define DENSITY(who)                                                           \
    KEY_REAL, "kg/m^3", "> 0", "", "density; asked for by " who, "EW18 2", "", \
        OF(density)
#define MOVES(words, first, what)                                              \
    KEY_NAME, "", words, first, what, "", "", OF(motion), .choices = motions
#define MOVES_FREELY                                                           \
    MOVES("free | fixed | prescribed | spring", "free",                        \
          "moved by the fluid; at rest; with velocity and spin as they are; "  \
          "or moved against a spring")
#define STANDS                                                                 \
    MOVES("fixed | free | prescribed | spring", "fixed",                       \
          "at rest; moved by fluid, particles and contacts; with velocity "    \
          "and spin as they are; or moved against a spring")
#define SPRING                                                                 \
    KEY_VECTOR, "N/m", ">= 0", ZERO,                                           \
        "stiffness along x, y, z; 0: it cannot move along that axis",          \
        "LS section 5.5", "", OF(spring)
#define VELOCITY                                                               \
    KEY_VECTOR, "m/s", "", ZERO, "velocity at time 0", "", "", OF(velocity)
#define SPIN(about)                                                            \
    KEY_VECTOR, "rad/s", "", ZERO, "angular velocity at time 0" about, "", "", \
        OF(spin)

const struct key bodies_setup_keys[] = {
    {"bodies", KEY_GROUP, "", "", KEY_OPTIONAL,
     "bodies of many cells, with the flow around them resolved", "EW18 1-4",
     "fluid", .divided = "bodies are not divided yet"},
    {"bodies.method", KEY_NAME, "", "", "hold", "how they hold the fluid",
     "LS 5.17-5.21", "", AT(method), .models = solid_bodies_methods},
    {"bodies.spheres", KEY_LIST, "", "", "",
     "each { position, diameter }, and what moves it", "EW18 2, 3", "",
     LIST_OF(BODY_SPHERES)},
    {"bodies.spheres.position", POSITION("centre at time 0")},
    {"bodies.spheres.diameter", DIAMETER},
    {"bodies.spheres.density", DENSITY("a free one, and by one on a spring")},
    {"bodies.spheres.motion", MOVES_FREELY},
    {"bodies.spheres.spring", SPRING},
    {"bodies.spheres.velocity", VELOCITY},
    {"bodies.spheres.spin", SPIN("")},
    {"bodies.boxes", KEY_LIST, "", "", "",
     "each { position, size }, and what moves it", "EW18 2, 3", "",
     LIST_OF(BODY_BOXES)},
    {"bodies.boxes.position", POSITION("centre at time 0")},
    {"bodies.boxes.size", KEY_VECTOR, "m", "> 0", NULL,
     "length of its edges, along x, y, z", "", "", OF(size)},
    {"bodies.boxes.rotation", KEY_VECTOR, "rad", "", ZERO,
     "how it is turned at time 0: the direction is the axis, the length the "
     "angle",
     "", "", OF(rotation)},
    {"bodies.boxes.motion", STANDS},
    {"bodies.boxes.spring", SPRING},
    {"bodies.boxes.density", DENSITY("one that is moved")},
    {"bodies.boxes.velocity", VELOCITY},
    {"bodies.boxes.spin", SPIN("")},
    {"bodies.cylinders", KEY_LIST, "", "", "",
     "each { position, diameter, length, axis }, and what moves it",
     "EW18 2, 3", "", LIST_OF(BODY_CYLINDERS)},
    {"bodies.cylinders.position", POSITION("centre at time 0")},
    {"bodies.cylinders.diameter", DIAMETER},
    {"bodies.cylinders.length", KEY_REAL, "m", "> 0", NULL,
     "length; twice the box for one without ends", "", "", OF(length)},
    {"bodies.cylinders.axis", KEY_VECTOR, "-", "", "[0.0, 0.0, 1.0]",
     "direction of its axis", "", "", OF(axis)},
    {"bodies.cylinders.motion", STANDS},
    {"bodies.cylinders.spring", SPRING},
    {"bodies.cylinders.density", DENSITY("one that is moved")},
    {"bodies.cylinders.velocity", VELOCITY},
    {"bodies.cylinders.spin", SPIN("")},
    {"bodies.clumps", KEY_LIST, "", "", "",
     "each { file, position }, spheres that are one body", "EW18 2, 3", "",
     LIST_OF(BODY_CLUMPS)},
    {"bodies.clumps.file", KEY_FILE, "", "", NULL,
     "lines of x y z d [m], a sphere each; they may overlap", "", "", OF(file)},
    {"bodies.clumps.scale", SCALE("factor of all numbers in the file")},
    {"bodies.clumps.position",
     POSITION("where the origin of the file is at time 0")},
    {"bodies.clumps.motion", MOVES_FREELY},
    {"bodies.clumps.spring", SPRING},
    {"bodies.clumps.density", DENSITY("one that is moved")},
    {"bodies.clumps.velocity", VELOCITY},
    {"bodies.clumps.spin", SPIN(", about its centroid")},
    {"bodies.surfaces", KEY_LIST, "", "", "",
     "each { file, position }, a body within a closed surface of triangles",
     "EW18 4", "", LIST_OF(BODY_SURFACES)},
    {"bodies.surfaces.file", KEY_FILE, "", "", NULL,
     "an STL file whose triangles close", "", "", OF(file)},
    {"bodies.surfaces.scale",
     SCALE("factor of all numbers in the file: 1e-3 if they are mm")},
    {"bodies.surfaces.position",
     POSITION("where the origin of the file is at time 0")},
    {"bodies.surfaces.motion", STANDS},
    {"bodies.surfaces.spring", SPRING},
    {"bodies.surfaces.density", DENSITY("one that is moved")},
    {"bodies.surfaces.velocity", VELOCITY},
    {"bodies.surfaces.spin", SPIN(", about its centroid")},
    {"bodies.virtual_mass", KEY_REAL, "-", ">= 0", "2.0",
     "C_v: fluid of so many volumes counts on both sides of the motion, which "
     "keeps light bodies stable; a light, thin or small one gets more",
     "EW18 2", "", AT(virtual_mass)},
    {"bodies.stiffness", KEY_REAL, "N/m", "> 0", "",
     "spring of their contacts; left out: an impact lasts eight steps",
     "LS 4.4", "", AT(stiffness)},
    {"bodies.restitution", KEY_REAL, "-", "> 0, <= 1", "0.97",
     "restitution coefficient of dry contacts", "LS 4.4", "", AT(restitution)},
    {"bodies.friction", KEY_REAL, "-", ">= 0", "0.15",
     "Coulomb's coefficient of friction", "LS 4.8", "", AT(friction)},
    {"bodies.max_overlap", KEY_REAL, "-", "> 0", "0.5",
     "the run stops at a deeper overlap over a diameter or width", "LS 4.7", "",
     AT(max_overlap)},
    {"bodies.lubrication", KEY_BOOL, "", "", "true",
     "the fluid that is squeezed out of gaps narrower than a cell", "Cox67", "",
     AT(lubrication)},
    {"bodies.roughness", KEY_REAL, "-", "> 0, < 1", "1e-3",
     "height of the asperities over the smallest radius, where two surfaces "
     "touch",
     "Cox67", "", AT(roughness)},
    {"bodies.filter", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "width of the cubes around the bodies over whose fluid bodies.csv has "
     "means, with C_d and Re_p by them; left out: none",
     "EW18 25-27", "", AT(filter)},
    KEY_END};
