/* snapshot_order.h -- particles in the order of their ids. */
#ifndef RECORD_SNAPSHOT_ORDER_H
#define RECORD_SNAPSHOT_ORDER_H

#include "record/snapshot.h"

/* From now on the snapshot has them so. */
void snapshot_order_by_id(struct snapshot *s);

#endif
