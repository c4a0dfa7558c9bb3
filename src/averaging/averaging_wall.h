/* averaging_wall.h -- solids inside the mesh that particles cannot be in.
 * Chapter "Resolving the grains".
 *
 * A method of averaging takes account of the walls of the mesh, not of other
 * solids: what it puts into the cells of these is moved out again, and a field
 * is continued into them before it is interpolated. The two are adjoint, so
 * that the sums of averaging.h are conserved.
 */
#ifndef AVERAGING_AVERAGING_WALL_H
#define AVERAGING_AVERAGING_WALL_H

struct averaging_wall {
    /* Moves the densities of the closed cells to open ones; sum V field stays.
     */
    void (*move_out)(const struct averaging_wall *self, int m, double *field);
    /* The same field with values in the closed cells; borrowed, until the next
     * call. */
    const double *(*extend)(struct averaging_wall *self, int m,
                            const double *field);
};

#endif
