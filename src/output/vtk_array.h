/* vtk_array.h -- one named array of numbers in a VTK file.
 *
 * The numbers are not copied: they may be interleaved, in one array a
 * component, or integers. They are Float64 in the file, bit for bit what was
 * computed, or Float32 if `single` is set: seven digits at half the size,
 * enough for values that are only displayed (velocities), but not for
 * positions, whose differences are overlaps of 1e-4 d, nor for values that will
 * be summed.
 *
 * Fill it by name: {.name = "velocity", .components = 3, .split = {vx, vy, vz}}
 */
#ifndef OUTPUT_VTK_ARRAY_H
#define OUTPUT_VTK_ARRAY_H

#include <stddef.h>

struct vtk_array {
    const char *name;
    int components;             /* [-] numbers a point or cell, 1 to 9 */
    const double *values;       /* side by side, [components * i + k]; or */
    const double *split[3];     /* one array a component; or */
    const int *ints;            /* whole numbers, side by side, Int32; or */
    const unsigned char *bytes; /* small ones, UInt8; or */
    int from;   /* if all are NULL: from, from + 1, ... as Int32 */
    int single; /* [-] 1: Float32 */
};

/* VTK's name of its type: "Float64", "Float32", "Int32", "UInt8". */
const char *vtk_array_type(const struct vtk_array *a);

/* Bytes of one number in the file. */
size_t vtk_array_width(const struct vtk_array *a);

/* Copies n numbers from number `first` on, in the type of the file. */
void vtk_array_copy(const struct vtk_array *a, size_t first, size_t n,
                    void *bytes);

#endif
