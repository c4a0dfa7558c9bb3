/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distributed/ranks/engine.h"

#include <math.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "case/case_file.h"
#include "case/recorder_part.h"
#include "coupling/coupling.h"
#include "coupling/transfer.h"
#include "distributed/refusal.h"
#include "distributed/ranks/part.h"

enum order { CREATE, START, STEP, COLLECT, SAVE, LOAD, RELEASE, STOP };
enum { FILE_NAME = 256 };

/* What output is made of, of all that a fluid has. */
static const char of_output[] =
    "t dt_older u p eps eps_n eps_nm1 eps_us residual p_face phi "
    "mean_gradient relabelled";

/* Of each rank. */
struct engine {
    struct processes
        hooks; /* the first, so that a pointer to it is one to all */
    const struct settings *settings;
    struct simulation *record; /* on the first rank; elsewhere NULL */
    struct part *part;
    struct settings *own; /* settings that were read here, or NULL */
    int broken; /* [-] 1: the last step has failed, and is not recorded */
    long moved; /* [-] spheres on another rank than at first, when last seen */
};

static struct engine *of(struct processes *hooks)
{
    return (struct engine *)hooks;
}

static void give(enum order order, int detail)
{
    int message[2] = {(int)order, detail};

    MPI_Bcast(message, 2, MPI_INT, 0, MPI_COMM_WORLD);
}

/* The largest of the codes: all ranks go on, or none does. */
static int agree(int code)
{
    MPI_Allreduce(MPI_IN_PLACE, &code, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return code;
}

/* --- what each rank does ---------------------------------------------------
 */

/* The part, in which nothing is yet. */
static int make_part(struct engine *e)
{
    int code;

    part_free(e->part);
    e->part = part_create(e->settings, MPI_COMM_WORLD, e->record, &code);
    return agree(code);
}

/* Reports of the part, which all ranks agree on, to the record. */
static void report(struct engine *e)
{
    struct simulation *const whole = e->record;
    const struct simulation *const sim = e->part->sim;

    if (whole == NULL) return;
    whole->fluid->t = sim->fluid->t;
    whole->fluid->report = sim->fluid->report;
    whole->coupling->report = sim->coupling->report;
    whole->coupling->report.exchange_residual = e->part->exchange_residual;
    whole->dem_report = sim->dem_report;
    whole->t = sim->t;
    whole->steps = sim->steps;
    whole->seconds.cfd = sim->seconds.cfd;
    whole->seconds.dem = sim->seconds.dem;
    whole->seconds.averaging = sim->seconds.averaging;
    whole->seconds.exchange = sim->seconds.exchange;
}

static int start_part(struct engine *e)
{
    int code = make_part(e);

    if (code != 0) return code;
    spheres_place(e->part->spheres, e->record ? e->record->particles : NULL);
    code = agree(coupling_start(e->part->sim));
    report(e);
    return code;
}

/* Where a lost sphere was last recorded. */
static void find_lost(struct simulation *whole)
{
    struct dem_report *const r = &whole->dem_report;
    const struct particles *const ps = whole->particles;

    if (r->lost != 1 || r->lost_id < 0 || isfinite(r->lost_at[0])) return;
    r->lost_at[0] = ps->x[r->lost_id];
    r->lost_at[1] = ps->y[r->lost_id];
    r->lost_at[2] = ps->z[r->lost_id];
}

static int step_part(struct engine *e)
{
    const int failed = agree(coupling_step(e->part->sim));

    e->broken = failed;
    report(e);
    if (failed && e->record != NULL) find_lost(e->record);
    return failed;
}

static void collect_part(struct engine *e, int extent)
{
    transfer_solids_velocity(e->part->sim);
    part_collect(e->part, e->record,
                 extent == PROCESSES_ALL ? NULL : of_output);
    e->moved = spheres_moved(e->part->spheres);
}

static void take_reports(struct engine *e)
{
    struct simulation *const sim = e->part->sim;
    struct coupling_report *const r = &sim->coupling->report;
    double numbers[8] = {0.0};

    if (e->record != NULL) {
        const struct coupling_report *const from = &e->record->coupling->report;
        const double known[8] = {e->record->t,
                                 (double)e->record->steps,
                                 from->substeps,
                                 from->shortest_time,
                                 from->eps_lowest,
                                 from->seen_lowest,
                                 from->exchange_residual,
                                 0.0};
        memcpy(numbers, known, sizeof known);
        sim->seconds = e->record->seconds;
        sim->force_scale = e->record->force_scale;
        for (int i = 0; i < sim->n_effects; i++)
            sim->effects[i].tally = e->record->effects[i].tally;
    }
    MPI_Bcast(numbers, 8, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    sim->t = numbers[0];
    sim->steps = (long)numbers[1];
    r->substeps = (int)numbers[2];
    r->shortest_time = numbers[3];
    r->eps_lowest = numbers[4];
    r->seen_lowest = numbers[5];
    e->part->exchange_residual = numbers[6];
}

/* The record was loaded: fields from it, spheres from the file of LAMMPS. */
static int load_part(struct engine *e, const char *file)
{
    const int code = make_part(e);

    if (code != 0) return code;
    part_spread(e->part, e->record);
    spheres_load(e->part->spheres, file);
    take_reports(e);
    return agree(averaging_bind(e->part->sim->averaging));
}

/* --- what the first rank asks ----------------------------------------------
 */

static int start(struct processes *self)
{
    give(START, 0);
    return start_part(of(self));
}

static int step(struct processes *self)
{
    give(STEP, 0);
    return step_part(of(self));
}

static void collect(struct processes *self, enum processes_extent extent)
{
    if (of(self)->part == NULL || of(self)->broken) return;
    give(COLLECT, (int)extent);
    collect_part(of(self), (int)extent);
}

/* A file that only this rank need see. */
static void temporary(char name[FILE_NAME])
{
    const char *const dir = getenv("TMPDIR");

    snprintf(name, FILE_NAME, "%s/winnow-XXXXXX", dir != NULL ? dir : "/tmp");
    const int file = mkstemp(name);
    if (file >= 0) close(file);
}

/* A file as whole numbers, after its length in bytes. Non-zero if it cannot be
 * read or written. */
static int file_state(const char *name, struct state *s)
{
    FILE *const f = fopen(name, s->loading ? "wb" : "rb");
    long bytes = 0;

    if (f == NULL) return 1;
    if (!s->loading && fseek(f, 0, SEEK_END) == 0) bytes = ftell(f);
    rewind(f);
    state_long(s, "bytes", "-", &bytes);
    const size_t n = (size_t)(bytes < 0 ? 0 : bytes);
    int *const words = alloc_zeroed(n / sizeof(int) + 1, sizeof *words);
    int wrong = !s->loading && fread(words, 1, n, f) != n;
    state_wholes(s, "lammps", "-", words, (long)(n / sizeof(int) + 1), 1);
    if (s->loading) wrong = fwrite(words, 1, n, f) != n;
    free(words);
    return fclose(f) != 0 || wrong;
}

static void visit(struct processes *self, struct state *s)
{
    struct engine *const e = of(self);
    char file[FILE_NAME];

    if (!s->loading && e->part == NULL) return;
    temporary(file);
    if (!s->loading) {
        give(SAVE, 0);
        spheres_save(e->part->spheres, file);
    }
    state_begin(s, "ranks");
    if (file_state(file, s) != 0 && !s->failed) {
        fprintf(stderr, "winnow: cannot write %s\n", file);
        s->failed = 1;
    }
    state_end(s);
    if (s->loading && !s->failed) {
        give(LOAD, 0);
        s->failed = load_part(e, file) != 0;
    }
    unlink(file);
}

static void release(struct processes *self)
{
    struct engine *const e = of(self);

    give(RELEASE, 0);
    part_free(e->part);
    free(e);
}

static int check(const struct settings *s)
{
    struct partition p;
    int code = refusal_engine(s);

    if (code == 0) code = part_divide(s, MPI_COMM_WORLD, &p);
    if (code == 0) partition_release(&p);
    return code;
}

static struct processes *create(const struct settings *s,
                                struct simulation *whole, int *code)
{
    struct engine *const e = alloc_zeroed(1, sizeof *e);

    e->hooks = (struct processes){.start = start,
                                  .step = step,
                                  .collect = collect,
                                  .state = visit,
                                  .free = release};
    e->settings = s;
    e->record = whole;
    give(CREATE, 0);
    *code = agree(0); /* the others have read the case */
    if (*code == 0) return &e->hooks;
    free(e);
    return NULL;
}

static void *create_summary(const struct settings *s,
                            const struct simulation *sim, struct folder *folder,
                            int *failed)
{
    (void)s, (void)folder, (void)failed;
    return sim->processes;
}

static void free_summary(void *part)
{
    (void)part; /* which build_free releases */
}

/* What differs from one machine stands in the summary. */
static void summarize(const void *part, struct summary *f)
{
    const struct engine *const e = part;
    const struct partition *const p = e->part != NULL ? &e->part->p : NULL;

    summary_begin(f, "engine");
    summary_text(f, "particles", "LAMMPS");
    summary_text(f, "linear_systems", "PETSc");
    summary_text(f, "same_results",
                 "to rounding for any number of ranks and after a resume, not "
                 "to the bit");
    if (p != NULL) {
        summary_count(f, "ranks", p->size);
        summary_count(f, "ranks_x", p->P[0]);
        summary_count(f, "ranks_y", p->P[1]);
        summary_count(f, "ranks_z", p->P[2]);
        summary_count(f, "layers", p->layers);
        summary_count(f, "particles_on_another_rank", e->moved);
    }
    summary_end(f);
}

const struct recorder_part engine_summary = {
    .create = create_summary, .free = free_summary, .summarize = summarize};

const struct processes_engine engine_of_ranks = {
    .name = "ranks", .check = check, .create = create};

void engine_stop(int code)
{
    give(STOP, code);
}

/* --- the other ranks -------------------------------------------------------
 */

/* The case that the command line names, which the first rank has checked. */
static struct settings *read_case(int argc, char **argv)
{
    const char **const overrides =
        alloc_zeroed((size_t)argc, sizeof *overrides);
    const char *file = "";
    int n = 0, code;

    for (int i = 2; i < argc; i++) {
        const int takes = argv[i][0] == '-' && strchr("osj", argv[i][1]) &&
                          argv[i][1] != '\0';
        const char *const value = takes && argv[i][2] == '\0' && i + 1 < argc
                                      ? argv[i + 1]
                                      : argv[i] + 2;
        if (argv[i][0] != '-') file = argv[i];
        if (takes && argv[i][1] == 's') overrides[n++] = value;
        i += takes && argv[i][2] == '\0';
    }
    struct settings *const s = case_file_read(file, n, overrides, &code);
    if (s != NULL) settings_be_quiet(s);
    free(overrides);
    return s;
}

static void obey(struct engine *e, enum order order, int detail)
{
    switch (order) {
    case START:
        start_part(e);
        break;
    case STEP:
        step_part(e);
        break;
    case COLLECT:
        collect_part(e, detail);
        break;
    case SAVE:
        spheres_save(e->part->spheres, "none");
        break;
    case LOAD:
        load_part(e, "none");
        break;
    case RELEASE:
        part_free(e->part);
        e->part = NULL;
        break;
    case CREATE:
    case STOP:
        break;
    }
}

int engine_serve(int argc, char **argv)
{
    struct engine e = {.settings = NULL};
    int message[2] = {CREATE, 0};

    while (message[0] != STOP) {
        MPI_Bcast(message, 2, MPI_INT, 0, MPI_COMM_WORLD);
        if (message[0] == CREATE) {
            e.own = read_case(argc, argv);
            e.settings = e.own;
            agree(e.own == NULL ? 4 : 0);
        }
        obey(&e, (enum order)message[0], message[1]);
    }
    settings_free(e.own);
    return message[1];
}
