/* case_materials.h -- the materials of a case, by name and by number, and what
 * attracts its particles.
 *
 * Number 0 is called "grains"; the others come in the order of the list
 * particles.materials. A sphere or a wall names its material, and
 * case_materials_number returns the number of that name.
 */
#ifndef CASE_PARTICLES_CASE_MATERIALS_H
#define CASE_PARTICLES_CASE_MATERIALS_H

#include "dem/attraction.h"
#include "dem/materials.h"
#include "case/settings.h"

/* The number of a name, 0 of NULL; -1 if there is no such material. */
int case_materials_number(const struct settings *s, const char *name);

/* How many there are for dem, and the number of one of them for a wall. */
int case_materials_total(const struct settings *s);
int case_materials_of_wall(const struct settings *s, const char *name);

/* What the case says of the material of a number; and the material itself, with
 * the numbers that the contact law alone reads. */
const struct material_setup *case_materials_setup(const struct settings *s,
                                                  int number);
struct material case_materials_one(const struct settings *s, int number);

/* All but number 0, to be released with free(); NULL if there is no other. */
struct materials *case_materials_create(const struct settings *s);

/* Each is given once, and what is made of a material names one that there is:
 * 0, or 2 after one message. */
int case_materials_check(const struct settings *s);

/* A name that the case gives at `path` must be one of the materials': 0, or 2
 * after one message. */
int case_materials_check_name(const struct settings *s, const char *path,
                              const char *name);

/* 1 if any two of them, or one with itself, resist rolling. */
int case_materials_resist_rolling(const struct settings *s);

/* The attractions that the case names, to be released with free(), and how
 * many; NULL if none. */
struct attraction *case_materials_attractions(const struct settings *s, int *n);

/* 0, or 2 after a message. */
int case_materials_check_attractions(const struct settings *s);
/* The same for the memory of the list of pairs, after all else of the particles
 * is checked. */
int case_materials_check_pairs(const struct settings *s);

/* The key of an attraction between particles and the walls of the box, and of
 * nothing else, that the case names; NULL: it names none. */
const char *case_materials_attraction_of_box(const struct settings *s);

#endif
