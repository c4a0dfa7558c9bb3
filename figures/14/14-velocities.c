/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 14-velocities.c -- runs a case of particles alone; their last velocities.
 *
 *     sh figures/run.sh figures/14/14-velocities.c -- cases/collision-3d.cfg
 */
#include <math.h>
#include <stdio.h>

#include "coupling/coupling.h"
#include "case/build.h"
#include "case/case_file.h"

int main(int argc, char **argv)
{
    int code;

    if (argc != 2) return 2;
    struct settings *const s = case_file_read(argv[1], 0, NULL, &code);
    if (s == NULL) return code;
    struct simulation *const sim = build_simulation(s, &code);
    if (sim == NULL) return code;
    const long steps = lround(settings_real(s, "output.end") / sim->dt);
    while (sim->steps < steps && coupling_step(sim) == 0) {
    }
    const struct particles *const ps = sim->particles;
    printf("id    v_x    v_y    v_z [m/s]\n");
    for (int id = 0; id < ps->n; id++)
        for (int i = 0; i < ps->n; i++)
            if (ps->id[i] == id)
                printf("%2d %6.3f %6.3f %6.3f\n", id, ps->vx[i], ps->vy[i],
                       ps->vz[i]);
    build_free(sim);
    settings_free(s);
    return 0;
}
