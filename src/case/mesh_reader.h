/* mesh_reader.h -- the hook for meshes that are no plain box. */
#ifndef CASE_MESH_READER_H
#define CASE_MESH_READER_H

#include "case/settings.h"

#include <libconfig.h>

struct mesh_reader {
    /* Is called before a case is checked. Where the mesh is read from files,
     * the tables that have keys of the sides of the box are replaced by tables
     * with the patches of the mesh. *made has the new tables at their places in
     * the list; each is released with free(), and so is the list; NULL: none.
     * 0, or 2 after a message. */
    int (*patches)(const struct settings *s, const config_t *tree,
                   const struct key **tables, struct key ***made);
    /* Reads or makes the mesh, which is kept in the settings; nothing for a
     * plain box. 0, or 2 after a message. */
    int (*read)(struct settings *s);
};

/* Ended by NULL: there is one, or none. */
extern const struct mesh_reader *const mesh_readers[];

#endif
