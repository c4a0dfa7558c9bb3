/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/pictures/picture.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "base/text.h"
#include "base/vector.h"

/* A particle to be drawn. */
struct disc {
    double x, y, z; /* [m] centre: right, up, towards the eye */
    double r;       /* [m] */
    double speed;   /* [m/s] */
};

/* Largest number of points; more would not be visible. */
static const int most_squares[3] = {200, 400, 50}; /* [-] */

static int by_speed(const void *a, const void *b)
{
    const struct disc *const p = a, *const q = b;
    return (p->speed > q->speed) - (p->speed < q->speed);
}

static int by_depth(const void *a, const void *b)
{
    const struct disc *const p = a, *const q = b;
    const int order = (p->z > q->z) - (p->z < q->z);

    return order != 0 ? order : by_speed(a, b);
}

void picture_put_row(FILE *out, int n, const double *row)
{
    char text[NUMBER_LENGTH];

    for (int i = 0; i < n; i++)
        fprintf(out, "%s%c", number_rounded(row[i], 6, text),
                i < n - 1 ? ' ' : '\n');
}

/* Seen along z, where that does not lead upwards. */
struct picture_view picture_view(const double up[3])
{
    const int u = vector_axis(up), deep = u == 2 ? 1 : 2;
    return (struct picture_view){{3 - u - deep, u, deep}, u == 1 ? 1.0 : -1.0};
}

static struct disc *discs_of(const struct picture *p)
{
    const struct picture_view see = picture_view(p->up);
    const int *const a = see.axis;
    struct disc *const discs = alloc_zeroed((size_t)p->n, sizeof discs[0]);

    for (int i = 0; i < p->n; i++)
        discs[i] = (struct disc){.x = p->x[a[0]][i],
                                 .y = p->x[a[1]][i],
                                 .z = see.nearer * p->x[a[2]][i],
                                 .r = 0.5 * p->d[i],
                                 .speed = sqrt(p->v[0][i] * p->v[0][i] +
                                               p->v[1][i] * p->v[1][i] +
                                               p->v[2][i] * p->v[2][i])};
    return discs;
}

struct file *picture_open(struct folder *folder, const char *name)
{
    char *const path = folder_file(folder, name);
    struct file *const f = path == NULL ? NULL : file_create(path);

    free(path);
    return f;
}

/* The nearer particles cover the farther ones. */
int picture_write_particles(struct folder *folder, const char *name,
                            const struct picture *p)
{
    struct file *const f = picture_open(folder, name);
    if (f == NULL) return 1;
    struct disc *const discs = discs_of(p);

    qsort(discs, (size_t)p->n, sizeof discs[0], by_depth);
    const struct picture_view see = picture_view(p->up);
    fprintf(file_stream(f), "# %c [m]  %c [m]  radius [m]  speed [m/s]\n",
            'x' + see.axis[0], 'x' + see.axis[1]);
    for (int i = 0; i < p->n; i++) {
        const struct disc *const s = &discs[i];
        picture_put_row(file_stream(f), 4,
                        (double[4]){s->x, s->y, s->r, s->speed});
    }
    free(discs);
    return file_commit(f);
}

/* The largest speed of all but 1 % of the particles: with the largest of all,
 * one fast particle would make the colours of the others equal. */
double picture_speed_scale(const struct picture *p)
{
    if (p->n == 0) return 0.0;
    struct disc *const discs = discs_of(p);
    qsort(discs, (size_t)p->n, sizeof discs[0], by_speed);
    const int i = number_clamped(0.99 * (p->n - 1), 0, p->n - 1);
    const double speed = discs[i].speed;
    free(discs);
    return speed;
}

/* Mean over the cells along the depth, weighted by their volumes; from the
 * first of them on. */
static double depth_average(const struct mesh *m, const double *eps, int first,
                            int step, int n)
{
    double amount = 0.0, volume = 0.0;

    for (int k = 0; k < n; k++) {
        const int c = first + k * step;
        amount += m->V[c] * eps[c];
        volume += m->V[c];
    }
    return amount / volume;
}

static void put_columns(FILE *out, const struct picture *p, const int a[3])
{
    const struct box *const b = &p->mesh->box;
    const int step[3] = {1, b->n[0], b->n[0] * b->n[1]};
    const double *const x = b->edge[a[0]], *const y = b->edge[a[1]];

    for (int j = 0; p->eps && j < b->n[a[1]]; j++)
        for (int i = 0; i < b->n[a[0]]; i++) {
            const double eps =
                depth_average(p->mesh, p->eps, i * step[a[0]] + j * step[a[1]],
                              step[a[2]], b->n[a[2]]);
            picture_put_row(out, 5,
                            (double[5]){x[i], x[i + 1], y[j], y[j + 1], eps});
        }
}

/* Mean of the cells at n points from x on along the depth; 0 if all points are
 * outside the mesh. */
static double picture_sampled(const struct picture *p, double x[3], int deep,
                              double step, int n)
{
    double sum = 0.0, offset[3];
    int met = 0;

    for (int k = 0; k < n; k++, x[deep] += step) {
        const int c = mesh_cell_and_offset(p->mesh, x, offset);
        if (c < 0) continue;
        sum += p->eps[c];
        met++;
    }
    return met > 0 ? sum / met : 0.0;
}

/* A polyhedral mesh has no columns of cells; squares half as wide as a mean
 * cell are used instead. */
static void put_squares(FILE *out, const struct picture *p, const int a[3])
{
    const struct mesh *const m = p->mesh;
    double volume = 0.0, width[3];
    int n[3];

    for (int c = 0; c < m->n_cells; c++)
        volume += m->V[c];
    for (int k = 0; k < 3; k++) {
        const double L = m->hi[a[k]] - m->lo[a[k]];
        const double fit = ceil(2.0 * L / cbrt(volume / m->n_cells));
        n[k] = number_clamped(fit, 1, most_squares[k]);
        width[k] = L / n[k];
    }
    for (int j = 0; p->eps && j < n[1]; j++)
        for (int i = 0; i < n[0]; i++) {
            const double x = m->lo[a[0]] + i * width[0];
            const double y = m->lo[a[1]] + j * width[1];
            double point[3];
            point[a[0]] = x + 0.5 * width[0];
            point[a[1]] = y + 0.5 * width[1];
            point[a[2]] = m->lo[a[2]] + 0.5 * width[2];
            const double eps = picture_sampled(p, point, a[2], width[2], n[2]);
            if (eps > 0.0)
                picture_put_row(
                    out, 5, (double[5]){x, x + width[0], y, y + width[1], eps});
        }
}

static int put_void_fraction(struct folder *folder, const struct picture *p)
{
    struct file *const f = picture_open(folder, "picture/void_fraction.txt");
    if (f == NULL) return 1;

    fprintf(file_stream(f), "# edges of a column of cells: left right bottom "
                            "top [m]  void fraction [-]\n");
    const struct picture_view see = picture_view(p->up);
    if (p->mesh->shape == NULL)
        put_columns(file_stream(f), p, see.axis);
    else
        put_squares(file_stream(f), p, see.axis);
    return file_commit(f);
}

void picture_put_number(FILE *out, const char *name, double value,
                        const char *unit)
{
    char text[NUMBER_LENGTH];

    fprintf(out, "%s = %s%s # [%s]\n", name, number_rounded(value, 9, text),
            value == floor(value) && fabs(value) < 1e9 ? ".0" : "", unit);
}

void picture_put_box(FILE *out, const struct picture *p, const int axis[2],
                     double fast)
{
    const double *const lo = p->mesh->lo, *const hi = p->mesh->hi;
    const int a = axis[0], b = axis[1];

    fprintf(out, "# The numbers of this run.\n");
    fputs("title = ", out);
    text_put(out, p->title, TEXT_GNUPLOT);
    fputc('\n', out);
    picture_put_number(out, "time", p->time, "s");
    picture_put_number(out, "x0", lo[a], "m");
    picture_put_number(out, "x1", hi[a], "m");
    picture_put_number(out, "y0", lo[b], "m");
    picture_put_number(out, "y1", hi[b], "m");
    fprintf(out, "right_up = '%c%c'\nturned = %d\n", 'x' + a, 'x' + b,
            p->up[b] < 0.0);
    picture_put_number(out, "fast", fast, "m/s, which 99 of 100 keep below");
}

void picture_put_program(FILE *out, const char *const *program)
{
    for (; *program != NULL; program++)
        fprintf(out, "%s\n", *program);
}

static int picture_put_script(struct folder *folder, const struct picture *p)
{
    struct file *const f = picture_open(folder, "picture/bed.gp");
    const double speed = picture_speed_scale(p);
    if (f == NULL) return 1;

    FILE *const out = file_stream(f);
    const struct picture_view see = picture_view(p->up);
    picture_put_box(out, p, see.axis, speed > 0.0 ? speed : 1.0);
    fprintf(out, "particles = %d\nwith_void = %d\nwith_pressure = %d\n", p->n,
            p->eps != NULL, p->pressure);
    fprintf(out, "with_walls = %d\n\n", p->walls);
    picture_put_program(out, picture_bed);
    return file_commit(f);
}

int picture_write(struct folder *folder, const struct picture *p)
{
    if (folder_make(folder, "picture") != 0) return 1;
    if (p->u != NULL && p->x[0] == NULL) return picture_flow_write(folder, p);
    return picture_write_particles(folder, "picture/particles.txt", p) ||
           put_void_fraction(folder, p) || picture_put_script(folder, p);
}

int picture_draw(struct folder *folder, const char *below, const char *png,
                 int *drawn)
{
    char above[64], log[64];

    snprintf(above, sizeof above, "../%s", png);
    snprintf(log, sizeof log, "%s/gnuplot.log", below);
    if (folder_add(folder, png) != 0 || folder_add(folder, log) != 0) return 1;
    char *const path = file_join(folder_name(folder), below);
    *drawn = gnuplot_draw(path, "bed.gp", "..", above) == 0;
    free(path);
    return 0;
}

/* --- gnuplot -------------------------------------------------------------- */

extern char **environ; /* POSIX: the program declares it itself */

/* The exit code of a child that could not start gnuplot. */
enum { NO_PROGRAM = 127 };

/* Restores the signals of the child to their defaults, so that Ctrl-C ends a
 * gnuplot that hangs. */
static void set_signals(posix_spawnattr_t *how)
{
    sigset_t none, pipe;

    sigemptyset(&none);
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    posix_spawnattr_init(how);
    posix_spawnattr_setsigmask(how, &none);
    posix_spawnattr_setsigdefault(how, &pipe);
    posix_spawnattr_setflags(how,
                             POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
}

/* Waits for the end of the child; a signal to this program ends the child,
 * which may hang. */
static int status_of(pid_t child)
{
    const struct timespec nap = {0, 5000000}; /* 5 ms */
    pid_t ended;
    int status;

    while ((ended = waitpid(child, &status, WNOHANG)) == 0) {
        if (interrupt_arrived()) kill(child, SIGKILL);
        nanosleep(&nap, NULL);
    }
    return ended == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* Runs the arguments as a command; its exit code, or -1 with errno if it could
 * not be started or did not end by itself. */
static int command_result(char *const arguments[], const char *log)
{
    posix_spawn_file_actions_t where;
    posix_spawnattr_t how;
    pid_t child;

    unlink(log);
    const int says =
        open(log, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (says < 0) return -1;
    (void)!write(says, GNUPLOT_SAYS, strlen(GNUPLOT_SAYS));
    set_signals(&how);
    posix_spawn_file_actions_init(&where);
    posix_spawn_file_actions_adddup2(&where, says, 1);
    posix_spawn_file_actions_adddup2(&where, says, 2);
    errno =
        posix_spawnp(&child, arguments[0], &where, &how, arguments, environ);
    posix_spawn_file_actions_destroy(&where);
    posix_spawnattr_destroy(&how);
    const int reason = errno;
    close(says);
    errno = reason;
    if (errno != 0) return -1;
    const int result = status_of(child);
    errno = EINTR;
    return result;
}

static int gnuplot_complaint(const char *folder, const char *script, int result,
                             int reason)
{
    if ((result < 0 && reason == ENOENT) || result == NO_PROGRAM)
        fprintf(stderr,
                "winnow: no picture, for there is no gnuplot here; install it "
                "(Debian, Ubuntu: apt-get install gnuplot-nox) and run gnuplot "
                "%s in %s\n",
                script, folder);
    else if (result < 0)
        fprintf(stderr, "winnow: no picture: gnuplot in %s: %s\n", folder,
                strerror(reason));
    else
        fprintf(stderr,
                "winnow: no picture: gnuplot failed; it says why in "
                "%s/gnuplot.log\n",
                folder);
    return 1;
}

/* The same, within the folder. */
static int drawn(const char *folder, const char *script, const char *above,
                 const char *png)
{
    char *const partial = alloc_zeroed(strlen(png) + 9, 1);

    strcat(strcpy(partial, png), ".partial");
    char *const arguments[] = {"gnuplot",     "-c",    (char *)script,
                               (char *)above, partial, NULL};
    unlink(partial); /* which might be a link */
    const int result = command_result(arguments, "gnuplot.log");
    int failed = 0;

    if (result != 0)
        failed = gnuplot_complaint(folder, script, result, errno);
    else if (rename(partial, png) != 0)
        failed = gnuplot_complaint(folder, script, -1, errno);
    if (failed) remove(partial);
    free(partial);
    return failed;
}

/* gnuplot is given plain names only, so the folder is the working directory for
 * the time of the call. */
int gnuplot_draw(const char *folder, const char *script, const char *above,
                 const char *png)
{
    const int home = open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);

    if (home < 0 || chdir(folder) != 0) {
        gnuplot_complaint(folder, script, -1, errno == ENOENT ? EIO : errno);
        if (home >= 0) close(home);
        return 1;
    }
    int failed = drawn(folder, script, above, png);
    if (fchdir(home) != 0)
        failed = gnuplot_complaint(folder, script, -1, errno);
    close(home);
    return failed;
}
