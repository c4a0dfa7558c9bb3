/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/manifest/written.h"

#include "base/file.h"
#include "base/text.h"
#include "output/manifest/manifest.h"
#include "output/pictures/gnuplot.h"

#include <errno.h>
#include <fcntl.h>
#include <fnmatch.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The folders in a run's own. */
const char *const written_folders[] = {
    ".",        "fluid",  "particles",   "surfaces",      "picture",
    "profiles", "frames", "statistics",  "walls",         "contacts",
    "case",     "bodies", "body_clumps", "body_surfaces", NULL};

/* Patterns of all files that a run may write, folder by folder, and what stands
 * at the start of each; "" for what a user has written, and for bare numbers.
 */
static const struct {
    const char *name, *holds;
} ours[] = {{"./summary.json", "\"program\": \"winnow "},
            {"./history.csv", "time [s],"},
            {"./probes.csv", "time [s],"},
            {"./surfaces.csv", "time [s],"},
            {"./bodies.csv", "time [s],"},
            {"./forces.csv", "time [s],"},
            {"./bodies.pvd", "<VTKFile"},
            {"./body_*.pvd", "<VTKFile"},
            {"./walls.pvd", "<VTKFile"},
            {"./contacts.pvd", "<VTKFile"},
            {"./fluid.pvd", "<VTKFile"},
            {"./particles.pvd", "<VTKFile"},
            {"./surfaces.pvd", "<VTKFile"},
            {"bodies/bodies_*.vtp", "<VTKFile"},
            {"body_*/body_*.vtp", "<VTKFile"},
            {"walls/walls_*.vtp", "<VTKFile"},
            {"contacts/contacts_*.vtp", "<VTKFile"},
            {"fluid/fluid_*vt?", "<VTKFile"},
            {"particles/particles_*vtp", "<VTKFile"},
            {"surfaces/surfaces_*.vtp", "<VTKFile"},
            {"./bed.png", "PNG\r\n"},
            {"./bed.gif", "GIF89a"},
            {"picture/particles.txt", "# x [m]"},
            {"picture/void_fraction.txt", "# edges of a column"},
            {"picture/flow.txt", "# place to the right"},
            {"picture/streamlines.txt", "# place to the right"},
            {"picture/walls.txt", "# x [m]"},
            {"picture/bed.gp", "# The numbers of this run."},
            {"picture/gnuplot.log", GNUPLOT_SAYS},
            {"frames/frame_*.txt", "# x [m]"},
            {"frames/bed.gp", "# The numbers of this run."},
            {"frames/gnuplot.log", GNUPLOT_SAYS},
            {"profiles/*.csv", "_mean ["},
            {"statistics/*.csv", "]"},
            {"statistics/summary.json", "\"blocks\": "},
            {"./case.cfg", "# The case of this run, by winnow "},
            {"case/*", ""}, /* see is_of_case */
            {"./checkpoint", "HDF\r\n"},
            {"./checkpoint.before", "HDF\r\n"},
            {"./checkpoint.cells.?", ""},
            {"./checkpoint.grains.?", "LammpS RestartT"}};
enum { N_OURS = sizeof ours / sizeof ours[0] };

int written_is_half(const char *name)
{
    const char *const end = strrchr(name, '.');

    return end != NULL && strcmp(end, ".partial") == 0;
}

const char *written_contents(const char *name)
{
    char *const whole = file_join(".", name);
    const char *found = NULL;

    if (written_is_half(name)) *strrchr(whole, '.') = '\0';
    for (int i = 0; i < N_OURS && found == NULL; i++)
        if (fnmatch(ours[i].name, &whole[strchr(name, '/') != NULL ? 2 : 0],
                    FNM_PATHNAME) == 0)
            found = ours[i].holds;
    free(whole);
    return found;
}

int written_folder(const char *name)
{
    const size_t n = strlen(name) - 1;

    for (int i = 1; written_folders[i] != NULL; i++)
        if (strlen(written_folders[i]) == n &&
            strncmp(written_folders[i], name, n) == 0)
            return name[n] == '/';
    return 0;
}

static int open_here(int here, const char *name)
{
    return openat(here, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
}

/* 1 if the case of the folder names the file, or a mesh of several files. */
static int is_of_case(int here, const char *name)
{
    const int file = open_here(here, "case.cfg");
    size_t length;
    char *const text = file < 0 ? NULL : manifest_text(file, &length);
    char quoted[2 * NAME_MAX + 16] = "";
    FILE *const out = fmemopen(quoted, sizeof quoted - 1, "w");

    text_put(out, name, TEXT_CASE);
    fclose(out);
    const int found = text != NULL && (strstr(text, quoted) != NULL ||
                                       strstr(text, "\"case\"") != NULL);
    free(text);
    if (file >= 0) close(file);
    return found;
}

int written_by_run(int here, const char *name)
{
    const char *const holds = written_contents(name);
    char text[512];
    struct stat s;

    if (name[strlen(name) - 1] == '/') return written_folder(name);
    if (holds == NULL) return 0;
    const int file = open_here(here, name);
    if (file < 0)
        return errno == ENOENT || (errno == ELOOP && written_is_half(name));
    const ssize_t n = fstat(file, &s) == 0 && S_ISREG(s.st_mode)
                          ? pread(file, text, sizeof text - 1, 0)
                          : -1;
    close(file);
    if (n <= 0) return n == 0;
    text[n] = '\0';
    return strstr(text, holds) != NULL &&
           (strncmp(name, "case/", 5) != 0 || is_of_case(here, name));
}
