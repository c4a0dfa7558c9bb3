/* case_population.h -- sources and sinks of particles, sizes of beds and placed
 * spheres that overlap: what a case says about them.
 * Chapter "Insertion, removal and energy".
 */
#ifndef CASE_PARTICLES_CASE_POPULATION_H
#define CASE_PARTICLES_CASE_POPULATION_H

#include "case/settings.h"
#include "coupling/simulation.h"
#include "dem/bed.h"
#include "dem/population/sizes.h"

/* Reads the files of the sources, and completes their options. 0, or 2 after a
 * message. */
int case_population_check(struct settings *s);
void case_population_release(struct settings *s);

/* The sizes of the bed, where they are not all equal. */
void case_population_bed_sizes(const struct settings *s, struct bed_options *b);

/* How many particles may be inserted after the start. */
int case_population_count(const struct settings *s);

/* Their smallest and largest diameter [m], of one material or, if it is
 * negative, of all; 0 if there are none. */
struct case_diameters {
    double min, max;
};
struct case_diameters case_population_diameters(const struct settings *s,
                                                int material);

/* Whether particles can start where they were placed; may move them. 0, or 2
 * after a message. */
int case_population_place(const struct settings *s, struct particles *ps,
                          const struct dem_options *o);

/* Adds sources and sinks to the particles that there are; the simulation
 * borrows their distributions and lists. */
void case_population_add(const struct settings *s, struct simulation *sim);

/* Inserts what is due before the first step, so that the start has it. 0, or 2
 * after a message. */
int case_population_start(const struct settings *s, struct simulation *sim);

/* Says which sources have spheres that are due and found no room. */
void case_population_report_waiting(const struct simulation *sim);

/* 1 if a signal ended the insertion of the last step early: it then differs
 * from that of a run without the signal. */
int case_population_is_cut_short(const struct simulation *sim);

/* --- case_parcels.c ------------------------------------------------------- */

/* Diameter of a parcel over that of its grains, l [-]; 1 without parcels, and
 * for a material that there is not that of the grains. */
double case_parcels_across(const struct settings *s, int material);

/* Of all materials, in a new table (dem/particles.h); NULL: all are grains. */
double *case_parcels_table(const struct settings *s);

/* Makes of the case, which says what the grains are, that of its parcels. 0, or
 * 2 after a message. */
int case_parcels_make(struct settings *s);
struct attraction;
void case_parcels_sizes(struct sizes_options *o, double l);
void case_parcels_attraction(const struct settings *s, struct attraction *a);

/* A note where the grains of the case are no whole number of parcels; and its
 * lines for `winnow check`: eps_s [-] where the particles are. */
void case_parcels_tell(const struct settings *s);
struct case_scales;
void case_parcels_print(const struct settings *s, const struct case_scales *k,
                        double eps_s);

/* The restitution of parcels whose grains have e; the walls keep theirs, for so
 * many grains strike them as do. */
double case_parcels_restitution(const struct settings *s, double e);
/* Whether parcels are to lose as much energy by collisions as their grains. */
int case_parcels_keep_dissipation(const struct settings *s);

#endif
