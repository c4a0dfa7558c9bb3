/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/checks.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "case/case_mesh.h"
#include "case/particles/case_clumps.h"
#include "coupling/processes.h"

static const char insert[] = "particles.insert";

/* [byte] The largest memory that was measured in runs, with the copy of the
 * state that a checkpoint is. A particle took 1256 in a bed that falls from a
 * lattice and 1724 in one that had settled. A cell of a box took 146 without a
 * fluid, 882 to 1131 with a fluid alone, 1409 to 1603 with particles in it; of
 * a mesh that has corners of its own 997, 1706 to 1878 and 2110 to 2653. */
static const double per_particle = 1480.0;
static const double per_cell[2][3] = {{150.0, 1080.0, 1500.0},
                                      {1100.0, 1800.0, 2400.0}};

/* So that sixteen numbers a particle are still numbered by an int. */
static const double most_particles = 134217727.0;

/* The particles of sources; those of files are counted when the files are
 * read. */
static double inserted(const struct settings *s)
{
    double sum = 0.0;

    for (int i = 0; i < s->particles.insert.n; i++)
        sum += case_clumps_balls(s, s->particles.insert.item[i].clump,
                                 s->particles.insert.item[i].count);
    return sum;
}

static double of_particles(const struct settings *s)
{
    if (!s->has.particles) return 0.0;
    return per_particle * (case_clumps_balls(s, s->particles.bed_clump,
                                             s->particles.bed.count) +
                           inserted(s) + s->particles.place.n);
}

static double of_cells(const struct settings *s)
{
    const int corners = s->mesh.polymesh != NULL || s->mesh.has_shear;
    const int kind = !s->has.fluid ? 0 : s->has.particles ? 2 : 1;

    return case_mesh_cells(s) * per_cell[corners][kind];
}

/* At most a thousand along each side, of two numbers each. */
static double of_samples(const struct settings *s)
{
    const double width = s->effects.mixing_sample;

    if (width == 0.0) return 0.0;
    const double n = case_mesh_volume(s) / pow(width, 3.0);
    return 2.0 * sizeof(double) * fmin(n, 1e9);
}

double case_memory_bytes(const struct settings *s)
{
    return of_cells(s) + of_particles(s) + of_samples(s);
}

/* The key that needs the most memory. */
static const char *largest_key(const struct settings *s, double more)
{
    if (more > of_cells(s) && more > of_particles(s))
        return KEY_OF(s, averaging.bandwidth);
    if (of_cells(s) > of_particles(s))
        return s->mesh.polymesh == NULL ? KEY_OF(s, mesh.box.cells)
                                        : KEY_OF(s, mesh.polymesh);
    return s->particles.bed.count > inserted(s) ? KEY_OF(s, particles.bed.count)
                                                : insert;
}

/* A case that several machines hold (chapter "Past one machine"). */
static int is_divided(const struct settings *s)
{
    return processes_engine != NULL || strcmp(s->engine, "distributed") == 0;
}

int case_memory_check(const struct settings *s, double more)
{
    const double need = case_memory_bytes(s) + more, have = alloc_most();
    const double n = of_particles(s) / per_particle;

    if (is_divided(s)) return 0;
    if (n > most_particles)
        return settings_wrong(s,
                              s->particles.bed.count > inserted(s)
                                  ? KEY_OF(s, particles.bed.count)
                                  : insert,
                              "%.4g particles; no more than %.0f can be "
                              "numbered",
                              n, most_particles);
    if (need <= have) return 0;
    if (of_samples(s) > need - of_samples(s))
        return settings_wrong(s, KEY_OF(s, effects.mixing_sample),
                              "%.4g samples need about %.3g GB, and this "
                              "machine has %.3g GB for them",
                              of_samples(s) / (2.0 * sizeof(double)),
                              1e-9 * of_samples(s), 1e-9 * have);
    return settings_wrong(s, largest_key(s, more),
                          "%.4g cells and %.4g particles need about %.3g GB, "
                          "and this machine has %.3g GB for them",
                          case_mesh_cells(s), n, 1e-9 * need, 1e-9 * have);
}

/* A pair has an index and xi, in lists that grow by half; they are counted by
 * an int. */
int case_memory_check_pairs(const struct settings *s, const char *key,
                            double pairs)
{
    const double each = 1.5 * (sizeof(int) + 3 * sizeof(double));
    const double need = each * pairs + case_memory_bytes(s);

    if (pairs < INT_MAX && (is_divided(s) || need <= alloc_most())) return 0;
    return settings_wrong(
        s, key,
        "%.3g m: up to that gap there are %.3g pairs of particles in the list, "
        "%.3g GB, and this machine has %.3g GB for them; expected a small part "
        "of a diameter or a few of them",
        settings_real(s, key), pairs, 1e-9 * need, 1e-9 * alloc_most());
}
