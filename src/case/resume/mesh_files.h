/* mesh_files.h -- the files of a mesh that a case names by its folder. */
#ifndef CASE_RESUME_MESH_FILES_H
#define CASE_RESUME_MESH_FILES_H

#include <stddef.h>

/* Calls each(of, path) for each file of the mesh, packed or not, in a fixed
 * order. */
void mesh_files_each(const char *dir, void (*each)(void *of, const char *path),
                     void *of);

#endif
