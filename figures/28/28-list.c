/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists the arrays of a checkpoint: how many numbers, unit, name.
 *
 *   sh figures/run.sh figures/28/28-list.c -- out/seen/checkpoint
 *
 * With nothing but the library of HDF5: no file of Winnow's is included. */
#if __has_include(<hdf5.h>)
#include <hdf5.h>
#else /* Debian has it in a folder of its own, which pkg-config knows */
#include <hdf5/serial/hdf5.h>
#endif
#include <stdio.h>

static herr_t list(hid_t file, const char *name, const H5O_info_t *info,
                   void *all)
{
    char unit[64] = "";

    (void)all;
    if (info->type != H5O_TYPE_DATASET) return 0;
    const hid_t data = H5Dopen2(file, name, H5P_DEFAULT);
    if (H5Aexists(data, "unit") > 0) {
        const hid_t at = H5Aopen(data, "unit", H5P_DEFAULT);
        const hid_t type = H5Aget_type(at);
        H5Aread(at, type, unit);
        H5Tclose(type);
        H5Aclose(at);
        const hid_t space = H5Dget_space(data);
        printf("%6ld %-12s %s\n", (long)H5Sget_simple_extent_npoints(space),
               unit, name);
        H5Sclose(space);
    }
    H5Dclose(data);
    return 0;
}

int main(int argc, char **argv)
{
    const hid_t file =
        argc == 2 ? H5Fopen(argv[1], H5F_ACC_RDONLY, H5P_DEFAULT) : -1;

    if (file < 0) return 1;
    H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, list, NULL);
    H5Fclose(file);
    return 0;
}
