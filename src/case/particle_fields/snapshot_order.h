/* snapshot_order.h -- particles in the order of their ids. */
#ifndef CASE_PARTICLE_FIELDS_SNAPSHOT_ORDER_H
#define CASE_PARTICLE_FIELDS_SNAPSHOT_ORDER_H

#include "case/snapshot.h"

/* From now on the snapshot has them so. */
void snapshot_order_by_id(struct snapshot *s);

#endif
