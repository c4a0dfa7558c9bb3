/* build_free.h -- releases a simulation and all that was built for it. */
#ifndef CASE_BUILD_FREE_H
#define CASE_BUILD_FREE_H

#include "coupling/simulation.h"

/* Also one that was built in part; NULL is fine. */
void build_free(struct simulation *sim);

#endif
