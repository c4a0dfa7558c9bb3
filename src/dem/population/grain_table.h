/* grain_table.h -- grains from files, of other programs too.
 * Chapter "Insertion, removal and energy".
 *
 * A dump of LAMMPS or LIGGGHTS: of several snapshots the last. Or a data file
 * of theirs, with atoms of the style sphere. Or a table with a line of names
 * (base/csv.h). All have columns x, y, z [m] and one of d, diameter,
 * radius, r [m], in any order, among others. Or rows x y z d alone. What a file
 * says of its columns, units and number of grains must agree with its rows.
 */
#ifndef DEM_POPULATION_GRAIN_TABLE_H
#define DEM_POPULATION_GRAIN_TABLE_H

#include "base/file.h"
#include "dem/population/insertion.h"

/* The list in a file, to be freed; NULL after a message. */
struct insertion_sphere *grain_table_read(const char *path, long *n);
struct insertion_sphere *grain_table_parse(const struct input *in, long *n);

#endif
