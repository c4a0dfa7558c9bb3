/* read_mesh.h -- checks what a case says about its mesh, and reads or makes one
 * that is no plain box.
 */
#ifndef CASE_READ_MESH_H
#define CASE_READ_MESH_H

#include "case/settings.h"

/* The mesh is kept in the settings. 0, or 2 after a message. */
int read_mesh(struct settings *s);

#endif
