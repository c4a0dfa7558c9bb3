/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/folder.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/text.h"
#include "output/pictures/picture.h"

#include <errno.h>
#include <fcntl.h>
#include <fnmatch.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char summary[] = "summary.json";

static int manifest_complaint(const char *what, const char *dir,
                              const char *name)
{
    fprintf(stderr, "winnow: cannot %s %s/%s: %s\n", what, dir, name,
            strerror(errno));
    return 1;
}

/* --- reading -------------------------------------------------------------- */

/* A name that stays where it is. */
static int is_plain(const char *part, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if ((unsigned char)part[i] < 0x20 || part[i] == 0x7f) return 0;
    return length > 0 && strncmp(part, ".", length) != 0 &&
           strncmp(part, "..", length) != 0;
}

/* "a" or "a/b", or the folder "a/". */
static int manifest_is_inside(const char *name)
{
    const char *const slash = strchr(name, '/');

    if (slash == NULL) return is_plain(name, strlen(name));
    return is_plain(name, (size_t)(slash - name)) &&
           (slash[1] == '\0' || (strchr(slash + 1, '/') == NULL &&
                                 is_plain(slash + 1, strlen(slash + 1))));
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* The descriptor is not duplicated: to close another one would release the
 * lock. */
static char *manifest_text(int file, size_t *length)
{
    struct stat s;

    if (fstat(file, &s) != 0) return NULL;
    if (!S_ISREG(s.st_mode)) {
        errno = EINVAL;
        return NULL;
    }
    char *const text = alloc_zeroed((size_t)s.st_size + 1, 1);
    for (*length = 0; *length < (size_t)s.st_size;) {
        const ssize_t n = pread(file, text + *length,
                                (size_t)s.st_size - *length, (off_t)*length);
        if (n <= 0) {
            free(text);
            return NULL;
        }
        *length += (size_t)n;
    }
    return text;
}

static int foreign(const char *path, int line)
{
    fprintf(stderr,
            "winnow: %s:%d: not the list of a run's files; to run here, move "
            "what is in the folder away, or choose another one with -o\n",
            path, line);
    return 1;
}

/* The names of the lines of a text from `at` on, up to the first line that
 * names nothing inside; the number of lines that name something. A last line
 * without a newline was cut off by a crash and is dropped. */
static int manifest_split(struct manifest *m, char *at, size_t length)
{
    char *const after = at + length;
    int lines = 0;

    for (size_t i = 0; i < length; i++)
        lines += at[i] == '\n';
    m->name = alloc_zeroed((size_t)lines, sizeof *m->name);
    for (char *end; (end = memchr(at, '\n', (size_t)(after - at))) != NULL;
         at = end + 1) {
        *end = '\0';
        if (strlen(at) != (size_t)(end - at) || !manifest_is_inside(at)) break;
        m->name[m->n++] = at;
    }
    qsort(m->name, (size_t)m->n, sizeof *m->name, by_name);
    return lines;
}

int manifest_read(struct manifest *m, int file, const char *path)
{
    size_t length = 0;

    *m = (struct manifest){0};
    errno = EIO;
    m->text = manifest_text(file, &length);
    if (m->text == NULL) {
        fprintf(stderr, "winnow: cannot read %s: %s\n", path, strerror(errno));
        return 1;
    }
    const size_t head = length > 0 ? strlen(MANIFEST_HEAD) : 0;
    if (strncmp(m->text, MANIFEST_HEAD, head) != 0) return foreign(path, 1);
    const int lines = manifest_split(m, m->text + head, length - head);
    return m->n < lines ? foreign(path, m->n + 2) : 0;
}

void manifest_release(struct manifest *m)
{
    free(m->text);
    free(m->name);
    *m = (struct manifest){0};
}

int manifest_has(const struct manifest *m, const char *name)
{
    return m->n > 0 && bsearch(&name, m->name, (size_t)m->n, sizeof *m->name,
                               by_name) != NULL;
}

/* --- removing ------------------------------------------------------------- */

/* Removes one file, *removed counts it; none is as good. */
static int remove_one(int here, const char *name, int *removed)
{
    if (unlinkat(here, name, 0) != 0) return errno != ENOENT;
    (*removed)++;
    return 0;
}

/* Removes the file and its partial version. */
static int remove_both(int here, const char *name, int *removed)
{
    char *const partial = alloc_zeroed(strlen(name) + 9, 1);
    int parts = 0;

    strcat(strcpy(partial, name), ".partial");
    const int failed = remove_one(here, name, removed) != 0 ||
                       remove_one(here, partial, &parts) != 0;
    free(partial);
    return failed;
}

/* "a/b": b in the folder a, if that is a folder and no link to one. "a/": the
 * folder, if it is empty. */
static int remove_below(int here, const char *name, int *removed)
{
    const char *const slash = strchr(name, '/');
    char *const folder = alloc_zeroed(strlen(name) + 1, 1);
    int failed = 0;

    memcpy(folder, name, (size_t)(slash - name));
    const int below =
        openat(here, folder, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (below < 0)
        failed = errno != ENOENT;
    else if (slash[1] == '\0')
        unlinkat(here, folder, AT_REMOVEDIR);
    else
        failed = remove_both(below, slash + 1, removed);
    const int reason = errno;
    if (below >= 0) close(below);
    free(folder);
    errno = reason;
    return failed;
}

int manifest_remove(const struct manifest *m, int here, const char *dir,
                    int *removed)
{
    *removed = 0;
    if (manifest_has(m, summary) && remove_both(here, summary, removed) != 0)
        return manifest_complaint("remove", dir, summary);
    for (int i = m->n - 1; i >= 0; i--) { /* "a/" after all "a/b" */
        const int failed = strchr(m->name[i], '/') == NULL
                               ? remove_both(here, m->name[i], removed)
                               : remove_below(here, m->name[i], removed);
        if (failed) return manifest_complaint("remove", dir, m->name[i]);
    }
    return 0;
}

/* Only the names that `kept` does not have. */
static void forget_kept(struct manifest *m, const struct manifest *kept)
{
    int n = 0;

    for (int i = 0; i < m->n; i++)
        if (!manifest_has(kept, m->name[i])) m->name[n++] = m->name[i];
    m->n = n;
}

int manifest_cut(int file, const char *path, long length, int here,
                 const char *dir)
{
    size_t all = 0, kept = (size_t)length;
    char *const text = manifest_text(file, &all);
    int removed;

    if (text == NULL || all < kept || kept < strlen(MANIFEST_HEAD)) {
        fprintf(stderr, "winnow: %s lists the files of another run\n", path);
        free(text);
        return 1;
    }
    struct manifest old = {.text = text}, gone = {0};
    const size_t head = strlen(MANIFEST_HEAD);
    manifest_split(&old, text + head, kept - head);
    manifest_split(&gone, text + kept, all - kept);
    forget_kept(&gone, &old);
    const int failed = manifest_remove(&gone, here, dir, &removed);
    manifest_release(&old);
    manifest_release(&gone);
    if (!failed && ftruncate(file, length) != 0)
        return manifest_complaint("cut", dir, "manifest.txt");
    return failed;
}

/* --- which files a run writes --------------------------------------------- */

/* The folders in a run's own. */
const char *const manifest_folders[] = {
    ".",        "fluid",  "particles",   "surfaces",      "picture",
    "profiles", "frames", "statistics",  "walls",         "contacts",
    "case",     "bodies", "body_clumps", "body_surfaces", NULL};

/* Patterns of all files that a run may write, folder by folder, and what stands
 * at the start of each; "" for what a user has written, and for bare numbers.
 */
static const struct {
    const char *name, *holds;
} ours[] = {{"./summary.json", "\"program\": \"winnow "},
            {"./report.html", "<!-- report of winnow"},
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
            {"bodies/bodies_*.vt?", "<VTKFile"},
            {"body_*/body_*.vt?", "<VTKFile"},
            {"walls/walls_*.vt?", "<VTKFile"},
            {"contacts/contacts_*.vt?", "<VTKFile"},
            {"fluid/fluid_*vt?", "<VTKFile"},
            {"particles/particles_*vt?", "<VTKFile"},
            {"surfaces/surfaces_*.vt?", "<VTKFile"},
            {"./bed.png", "PNG\r\n"},
            {"./bed.gif", "GIF89a"},
            {"picture/particles.txt", " [m]  radius [m]"},
            {"picture/void_fraction.txt", "# edges of a column"},
            {"picture/flow.txt", "# place to the right"},
            {"picture/streamlines.txt", "# place to the right"},
            {"picture/walls.txt", " [m], two points"},
            {"picture/bed.gp", "# The numbers of this run."},
            {"picture/gnuplot.log", GNUPLOT_SAYS},
            {"frames/frame_*.txt", " [m]  radius [m]"},
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

int manifest_is_half(const char *name)
{
    const char *const end = strrchr(name, '.');

    return end != NULL && strcmp(end, ".partial") == 0;
}

const char *manifest_contents(const char *name)
{
    char *const whole = file_join(".", name);
    const char *found = NULL;

    if (manifest_is_half(name)) *strrchr(whole, '.') = '\0';
    for (int i = 0; i < N_OURS && found == NULL; i++)
        if (fnmatch(ours[i].name, &whole[strchr(name, '/') != NULL ? 2 : 0],
                    FNM_PATHNAME) == 0)
            found = ours[i].holds;
    free(whole);
    return found;
}

int manifest_is_folder(const char *name)
{
    const size_t n = strlen(name) - 1;

    for (int i = 1; manifest_folders[i] != NULL; i++)
        if (strlen(manifest_folders[i]) == n &&
            strncmp(manifest_folders[i], name, n) == 0)
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

int manifest_is_of_run(int here, const char *name)
{
    const char *const holds = manifest_contents(name);
    char text[512];
    struct stat s;

    if (name[strlen(name) - 1] == '/') return manifest_is_folder(name);
    if (holds == NULL) return 0;
    const int file = open_here(here, name);
    if (file < 0)
        return errno == ENOENT || (errno == ELOOP && manifest_is_half(name));
    const ssize_t n = fstat(file, &s) == 0 && S_ISREG(s.st_mode)
                          ? pread(file, text, sizeof text - 1, 0)
                          : -1;
    close(file);
    if (n <= 0) return n == 0;
    text[n] = '\0';
    return strstr(text, holds) != NULL &&
           (strncmp(name, "case/", 5) != 0 || is_of_case(here, name));
}
