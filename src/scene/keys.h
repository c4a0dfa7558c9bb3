/* keys.h -- every key of a case file, in one table.
 *
 * Effects bring further rows in their descriptors. How a table is searched and
 * how a row is worded stands in rows.h.
 */
#ifndef KEYS_H
#define KEYS_H

#include "base/key.h"

extern const struct key keys_core[];

#endif
