/* mesh_form.h -- meshes that are no plain box.  Chapter "The mesh".
 *
 * A form of mesh is one descriptor. A case has the form whose key it gives: the
 * mesh comes from the files of a folder, or is made of the box of the case and
 * three numbers.
 */
#ifndef MESH_MESH_FORM_H
#define MESH_MESH_FORM_H

#include "base/key.h"
#include "mesh/mesh.h"

struct mesh_patch_name {
    char name[64];
};

struct mesh_form {
    const struct key *keys; /* the first row is the one that chooses it */

    /* From files; NULL for the others. Whether there is a mesh in the folder,
     * and where it was looked for; the number of its patches that are not
     * periodic and a list of them that the caller frees, or -1 after a message;
     * and the mesh, or NULL after a message. */
    int (*is_there)(const char *dir);
    const char *looked_for;
    int (*patches)(const char *dir, struct mesh_patch_name **list);
    struct mesh *(*read)(const char *dir);

    /* Of the box and three numbers; NULL for the others. */
    struct mesh *(*of_box)(const struct box_spec *spec, const double v[3]);
};

/* All of them, ended by NULL. */
extern const struct mesh_form *const mesh_forms[];

#endif
