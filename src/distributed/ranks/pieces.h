/* pieces.h -- fields and particles of all ranks as files.
 * Chapter "Past one machine".
 *
 * For ParaView each rank writes a piece, and the first one a file that lists
 * them. For a resume there are two files of all ranks together: the cells, in
 * the order of the whole box, and what LAMMPS writes; so that any number of
 * ranks can read them.
 */
#ifndef DISTRIBUTED_RANKS_PIECES_H
#define DISTRIBUTED_RANKS_PIECES_H

#include "record/snapshot.h"
#include "distributed/ranks/part.h"

/* The piece of a rank of the file DIR/NAME.pvtr: NAME_RANK.vtr, after DIR/ or
 * not. */
enum { PIECES_PATH = 4096 };
void pieces_name(const char *path, int rank, int with_folder,
                 char name[PIECES_PATH]);

/* Writes the piece of this rank of PATH.pvtr or PATH.pvtp, and on the first
 * rank that file. Non-zero after a message. */
int pieces_write(const struct part *part, const struct snapshot *s,
                 const char *path);

/* Copies all to the first rank's snapshot; elsewhere whole is NULL. Particles
 * go along if `with` is not 0. */
void pieces_gather(const struct part *part, const struct snapshot *s,
                   struct snapshot *whole, int with);

/* Visits fluid and coupling (state.h): cells and faces by the file, single
 * numbers by the first rank's `to` (elsewhere NULL). Returns a checksum of what
 * the file has, the same on all ranks; -1 after a message. */
long pieces_visit(struct part *part, const char *file, struct state *to,
                  int loading);

#endif
