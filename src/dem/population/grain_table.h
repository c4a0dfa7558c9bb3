/* grain_table.h -- grains from the files of other programs.
 * Chapter "Insertion, removal and energy".
 *
 * A dump of LAMMPS or LIGGGHTS: of several snapshots the last. Or a data file
 * of theirs, with atoms of the style sphere. Or a table with a line of names
 * (base/tables/csv.h). Both have columns x, y, z [m] and one of d, diameter,
 * radius [m], in any order, among others.
 */
#ifndef DEM_POPULATION_GRAIN_TABLE_H
#define DEM_POPULATION_GRAIN_TABLE_H

#include "dem/population/insertion.h"

/* 1 if the file begins with a name, with a snapshot or with a count of atoms.
 */
int grain_table_is(const char *path);

/* As insertion_read. */
struct insertion_sphere *grain_table_read(const char *path, long *n);

#endif
