/* keys.h -- every key of a case file, in one table.
 *
 * Effects bring further rows in their descriptors. How a table is searched and
 * how a row is put into words is in schema.h.
 */
#ifndef CASE_KEYS_H
#define CASE_KEYS_H

#include "base/key.h"

extern const struct key keys_case[];

#endif
