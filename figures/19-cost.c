/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs: vortices that a stream carries along, on meshes and with
 * steps, schemes, correctors and tolerances of all kinds. One line a run: which
 * question it belongs to, its setting, the error of the velocity over its
 * largest [-], and the processor time it took [s].
 *
 *   sh figures/run.sh figures/19-cost.c -- times|once|cheapest
 *
 * `times` takes the least of some repetitions; `once` runs each setting once,
 * to have its instructions counted (19-cost.sh); `cheapest` tries many settings
 * and says which come to 1 % and to 0.1 % in the least time. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "fluid/fluid.h"

static const double nu = 0.02, stream[2] = {1.0, 0.5}, end = 0.8;

static void exact(double x, double y, double t, double u[2])
{
    const double decay = exp(-2.0 * nu * t);
    const double a = x - stream[0] * t, b = y - stream[1] * t;

    u[0] = stream[0] + decay * sin(a) * cos(b);
    u[1] = stream[1] - decay * cos(a) * sin(b);
}

static void begin(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    for (int c = 0; c < m->n_cells; c++) {
        const double x = m->centre[3 * c], y = m->centre[3 * c + 1];
        exact(x, y, 0.0, &fl->u[3 * c]);
        fl->p[c] = 0.25 * (cos(2.0 * x) + cos(2.0 * y));
    }
    for (int f = 0; f < m->n_internal; f++) {
        const double *const x = &m->centre[3 * m->owner[f]];
        double u[2];
        exact(x[0] + 0.5 * m->d[3 * f], x[1] + 0.5 * m->d[3 * f + 1], 0.0, u);
        fl->phi[f] = m->S[3 * f] * u[0] + m->S[3 * f + 1] * u[1];
    }
}

static double error_of(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double sum = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        double u[2];
        exact(m->centre[3 * c], m->centre[3 * c + 1], fl->t, u);
        sum +=
            pow(fl->u[3 * c] - u[0], 2.0) + pow(fl->u[3 * c + 1] - u[1], 2.0);
    }
    return sqrt(0.5 * sum / m->n_cells);
}

/* What a setting gives and takes. */
struct cost {
    double error, seconds; /* [-], [s] */
};

static int steps_of(int n, double cfl)
{
    const double L = 8.0 * atan(1.0), fastest = 3.5; /* [m/s] |u| + |v| */

    return (int)ceil(end / (cfl * L / n / fastest));
}

static struct cost once(int n, double cfl, struct fluid_options o)
{
    const double L = 8.0 * atan(1.0);
    const struct box_spec spec = {{L, L, 1.0}, {n, n, 1}, {1, 1, 1}, {1, 1, 1}};
    struct mesh *const m = mesh_create_box(&spec);
    const int steps = steps_of(n, cfl);

    o.rho = 1.0;
    o.mu = nu;
    o.dt = end / steps;
    struct fluid *const fl = fluid_create(m, &o);
    begin(fl);
    const clock_t start = clock();
    for (int i = 0; i < steps; i++)
        if (fluid_step(fl) != 0) break;
    const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    const struct cost cost = {error_of(fl), seconds};
    fluid_free(fl);
    mesh_free(m);
    return cost;
}

/* The least time of as many runs as take a quarter of a second, five at most:
 * what else the machine does can only make it longer. */
static struct cost least(int n, double cfl, struct fluid_options o)
{
    struct cost cost = once(n, cfl, o);
    double spent = cost.seconds;

    for (int i = 1; i < 5 && spent < 0.25; i++) {
        const struct cost again = once(n, cfl, o);
        spent += again.seconds;
        cost.seconds = fmin(cost.seconds, again.seconds);
    }
    return cost;
}

/* How `run` measures. */
static int repeated;

static void run(const char *question, const char *setting, int n, double cfl,
                struct fluid_options o)
{
    const struct cost cost = repeated ? least(n, cfl, o) : once(n, cfl, o);

    printf("%s %s %d %.2f %.3e %.3g\n", question, setting, n, cfl, cost.error,
           cost.seconds);
}

static struct fluid_options options(const char *time, const char *convection)
{
    const struct fluid_options o = {.time = time_scheme_named(time),
                                    .convection =
                                        convection_scheme_named(convection),
                                    .blend = 0.8,
                                    .correctors = 2,
                                    .tolerance = 1e-6};

    return o;
}

static void ask_convection_and_time(void)
{
    static const char *const times[] = {"euler", "bdf2"};

    for (int n = 16; n <= 64; n *= 2)
        for (int i = 0; convection_schemes[i] != NULL; i++)
            run("convection", convection_schemes[i]->name, n, 0.25,
                options("bdf2", convection_schemes[i]->name));
    for (double cfl = 4.0; cfl > 0.2; cfl *= 0.5)
        for (int i = 0; i < 2; i++)
            run("time", times[i], 64, cfl, options(times[i], "linear"));
}

static void ask_correctors(void)
{
    static const char *const names[] = {"1", "2", "3", "4", "2-repeated"};

    for (double cfl = 4.0; cfl > 0.4; cfl *= 0.5)
        for (int i = 0; i < 5; i++) {
            struct fluid_options o = options("bdf2", "linear");
            o.correctors = i < 4 ? i + 1 : 2;
            o.outer_correctors = i < 4 ? 0 : 1;
            run("correctors", names[i], 48, cfl, o);
        }
}

static void ask_tolerance_and_mesh(void)
{
    for (int n = 24; n <= 48; n *= 2)
        for (int i = 1; i <= 9; i += i < 4 ? 1 : 2) {
            struct fluid_options o = options("bdf2", "linear");
            char name[16];
            o.tolerance = pow(10.0, -i);
            snprintf(name, sizeof name, "1e-%d", i);
            run("tolerance", name, n, 0.5, o);
        }
    for (double cfl = 2.0; cfl > 0.4; cfl *= 0.5)
        for (int n = 16; n <= 96; n += n < 32 ? 8 : n < 64 ? 16 : 32) {
            char name[16];
            snprintf(name, sizeof name, "cfl-%g", cfl);
            run("mesh", name, n, cfl, options("bdf2", "linear"));
        }
}

/* Whether this mesh and step are not worth a trial: more than twice the steps
 * of all cells that the best so far took, or four millions. */
static int hopeless(int n, double cfl, int at_n, double at_cfl)
{
    const double work = (double)n * n * steps_of(n, cfl);

    return work > 4e6 ||
           (at_n && work > 2.0 * at_n * at_n * steps_of(at_n, at_cfl));
}

/* The cheapest mesh and step of a pair of schemes that come to `goal`. */
static void search(const char *time, const char *convection, double goal)
{
    struct cost best = {0.0, INFINITY};
    double at_cfl = 0.0;
    int at_n = 0;

    for (int n = 16; n <= 96; n += n < 48 ? 8 : 16)
        for (double cfl = 4.0; cfl > 0.06; cfl *= 0.5) {
            if (hopeless(n, cfl, at_n, at_cfl)) break;
            const struct cost cost = once(n, cfl, options(time, convection));
            if (!(cost.error <= goal)) continue;
            const struct cost sure = least(n, cfl, options(time, convection));
            if (sure.seconds < best.seconds) {
                best = sure;
                at_cfl = cfl;
                at_n = n;
            }
            break; /* a shorter step only costs more */
        }
    if (at_n)
        printf("%.3f %s %s %d %.3g %.2e %.3g\n", goal, time, convection, at_n,
               at_cfl, best.error, best.seconds);
    else
        printf("%.3f %s %s - - - -\n", goal, time, convection);
}

static void find_cheapest(void)
{
    static const char *const times[] = {"euler", "bdf2"};
    static const char *const schemes[] = {"upwind", "linear", "second-upwind",
                                          "van-leer"};

    puts("# goal time convection cells_a_side courant error seconds");
    for (double goal = 0.01; goal > 5e-4; goal *= 0.1)
        for (int t = 0; t < 2; t++)
            for (int i = 0; i < 4; i++)
                search(times[t], schemes[i], goal);
}

int main(int argc, char **argv)
{
    if (argc > 1 && strcmp(argv[1], "cheapest") == 0) {
        find_cheapest();
        return 0;
    }
    repeated = argc > 1 && strcmp(argv[1], "times") == 0;
    ask_convection_and_time();
    ask_correctors();
    ask_tolerance_and_mesh();
    return 0;
}
