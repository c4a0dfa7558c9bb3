/* budget.h -- the energy budget as the sum over the chunks. Chapter "Insertion,
 * removal and energy". */
#ifndef DEM_FAST_BUDGET_H
#define DEM_FAST_BUDGET_H

#include "dem/energy.h"
#include "dem/fast/neighbours.h"

/* Sums all terms but `added` over the chunks. */
struct energy budget_collect(const struct neighbours *nb);

#endif
