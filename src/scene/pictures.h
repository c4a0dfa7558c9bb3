/* pictures.h -- the files that ParaView shows, written from a snapshot. */
#ifndef PICTURES_H
#define PICTURES_H

#include "effects/time_average.h"
#include "output/folder.h"
#include "scene/snapshot.h"

struct pictures;

/* The collections of the phases that there are; NULL after a message. */
struct pictures *pictures_create(const struct simulation *sim,
                                 struct folder *folder);
void pictures_free(struct pictures *p);

/* Non-zero after a message. */
int pictures_add(struct pictures *p, const struct snapshot *s);

/* The time of the last one [s]; -1 before the first. */
double pictures_last(const struct pictures *p);

#endif
