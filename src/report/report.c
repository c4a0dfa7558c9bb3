/* SPDX-License-Identifier: GPL-3.0-or-later */
/* report.c -- `winnow report`: a run, or several, as one page. */
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "case/case_file.h"
#include "case/command.h"
#include "case/schema.h"
#include "output/folder.h"
#include "report/page.h"
#include "tell/check.h"

/* Of the page, of what is put in it as text, and of its picture [byte]. The
 * lists of what was left out and the end of the page need no more than
 * PAGE_END. */
enum {
    PAGE_MOST = 6000000,
    PAGE_END = 100000,
    TEXT_MOST = 200000,
    PICTURE_MOST = 300000
};

long page_room(const struct page *p)
{
    return p->most - ftell(p->out);
}

static void page_put_lines(FILE *out, const char *text)
{
    char *const line = strdup(text);

    for (char *at = line, *end; at != NULL; at = end) {
        end = strchr(at, '\n');
        if (end != NULL) *end++ = '\0';
        text_put(out, at, TEXT_XML);
        if (end != NULL) fputc('\n', out);
    }
    free(line);
}

/* The lines of a text, `of` bytes, in a hidden element <pre data-name>. */
static void page_put_text(struct page *p, const char *name, const char *text)
{
    fprintf(p->out, "<pre hidden data-name=\"%s\">\n", name);
    page_put_lines(p->out, text);
    fputs("</pre>\n", p->out);
}

static void page_put_base64(FILE *out, const unsigned char *bytes, size_t n)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrst"
                                "uvwxyz0123456789+/";

    for (size_t i = 0; i < n; i += 3) {
        const unsigned b = bytes[i], c = i + 1 < n ? bytes[i + 1] : 0,
                       d = i + 2 < n ? bytes[i + 2] : 0;
        fputc(digit[b >> 2], out);
        fputc(digit[(b & 3) << 4 | c >> 4], out);
        fputc(i + 1 < n ? digit[(c & 15) << 2 | d >> 6] : '=', out);
        fputc(i + 2 < n ? digit[d & 63] : '=', out);
    }
}

/* Numbers that a float does not hold are none, as nan is. */
static int page_shows(double x)
{
    return x > -1e38 && x < 1e38;
}

void page_put_numbers(struct page *p, const struct page_numbers *of)
{
    double low = 0.0, high = 0.0;
    int any = 0;
    unsigned char *const bytes = alloc_zeroed(2 * of->n + 1, 1);

    for (size_t i = 0; i < of->n; i++) {
        const double x = of->value[i];
        if (!page_shows(x)) continue;
        low = !any || x < low ? x : low;
        high = !any || x > high ? x : high;
        any = 1;
    }
    for (size_t i = 0; i < of->n; i++) {
        const double x = of->value[i];
        const double part = high > low ? (x - low) / (high - low) : 0.0;
        const int whole = page_shows(x)
                              ? number_clamped(65534.0 * part + 0.5, 0, 65534)
                              : 65535;
        bytes[2 * i] = (unsigned char)(whole & 255);
        bytes[2 * i + 1] = (unsigned char)(whole >> 8);
    }
    fprintf(p->out,
            "<i hidden data-series=\"%s\" data-array=\"%s\" data-time=\"%.17g\""
            " data-low=\"%.17g\" data-high=\"%.17g\"%s>",
            of->series, of->name, of->time, low, high, of->more);
    page_put_base64(p->out, bytes, 2 * of->n);
    fputs("</i>\n", p->out);
    free(bytes);
}

/* --- the files of a run --------------------------------------------------- */

static void put_whole(struct page *p, const char *name)
{
    size_t length;
    char *const text = vtk_read_text(p->folder, name, &length);

    if (text != NULL && length > TEXT_MOST)
        texts_add(&p->left, "%s is too long for the page", name);
    else if (text != NULL)
        page_put_text(p, name, text);
    free(text);
}

/* Of the name of a profile, which is also that of an attribute. */
#define PROFILE_LETTERS                                                        \
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-"

/* The head, every so many of the other lines, and the last one. A line that is
 * being written is left out. */
static void page_put_table(struct page *p, const char *name, long most)
{
    size_t length;
    char *const text = vtk_read_text(p->folder, name, &length);
    long lines = 0, kept = 0, n = 0;

    if (text == NULL) return;
    for (const char *at = text; (at = strchr(at, '\n')) != NULL; at++)
        lines++;
    const long step = 1 + (long)length / most;
    fprintf(p->out, "<pre hidden data-name=\"%s\" data-rows=\"%ld\">\n", name,
            lines - 1);
    for (char *at = text, *end; (end = strchr(at, '\n')) != NULL;
         at = end + 1, n++) {
        *end = '\0';
        if (n > 0 && (n - 1) % step != 0 && n != lines - 1) continue;
        text_put(p->out, at, TEXT_XML);
        fputc('\n', p->out);
        kept++;
    }
    fputs("</pre>\n", p->out);
    if (step > 1)
        texts_add(&p->left, "%ld of %ld rows of %s are in the page", kept - 1,
                  lines - 1, name);
    free(text);
}

static void put_picture(struct page *p)
{
    size_t length;
    char *const bytes = vtk_read_text(p->folder, "bed.png", &length);

    if (bytes != NULL && length > PICTURE_MOST)
        texts_add(&p->left, "bed.png is too large for the page");
    else if (bytes != NULL) {
        fputs("<i hidden data-picture=\"bed.png\">", p->out);
        page_put_base64(p->out, (const unsigned char *)bytes, length);
        fputs("</i>\n", p->out);
    }
    free(bytes);
}

/* The profiles that the list of the folder names. */
static void put_profiles(struct page *p, long room)
{
    size_t length;
    char *const list = vtk_read_text(p->folder, "manifest.txt", &length);
    char *rest = list;

    for (const char *name; (name = strtok_r(rest, "\n", &rest)) != NULL;)
        if (strncmp(name, "profiles/", 9) == 0 &&
            strspn(name + 9, PROFILE_LETTERS) == strlen(name + 9) &&
            page_room(p) > room)
            page_put_table(p, name, TEXT_MOST);
    free(list);
}

/* 1 if a word of the case is the name of a key whose value is a file, or it
 * includes one: such a file may lie outside of the folder. */
static int may_name_a_file(const char *text)
{
    const struct key *tables[CASE_FILE_TABLES];

    if (strstr(text, "@include") != NULL) return 1;
    case_file_tables(tables);
    SCHEMA_EACH (key, tables) {
        const char *const word = strrchr(key->path, '.');
        if (key->type != KEY_FILE || word == NULL) continue;
        for (const char *at = text; (at = strstr(at, word + 1)) != NULL; at++)
            if (at == text || !isalpha((unsigned char)at[-1])) return 1;
    }
    return 0;
}

static void put_estimate(FILE *out, const struct effect_row *r)
{
    char verdict[CHECK_VERDICT];

    check_verdict(r, verdict);
    fprintf(out, "%s\t%.5g\t", r->effect->name, r->estimate.share);
    text_put(out, verdict, TEXT_XML);
    fputc('\n', out);
}

/* What `winnow check` says of the effects of the case: name, share (nan: none
 * is known), verdict. */
static void put_estimates(struct page *p, const char *dir)
{
    size_t length;
    char *const text = vtk_read_text(p->folder, "case.cfg", &length);
    char *const path = file_join(dir, "case.cfg");
    struct effect_row row[CHECK_EFFECTS];
    int code;
    struct settings *const s = text != NULL && !may_name_a_file(text)
                                   ? case_file_read(path, 0, NULL, &code)
                                   : NULL;

    fputs("<pre hidden data-name=\"estimates\">\n", p->out);
    if (s != NULL && s->has.particles) {
        const struct case_scales in = case_scales_of(s);
        struct effect_scales k = check_scales(s, &in);
        const int n = k.force > 0.0 ? check_effect_rows(s, &k, &in, row) : 0;
        for (int i = 0; i < n; i++)
            put_estimate(p->out, &row[i]);
    }
    fputs("</pre>\n", p->out);
    settings_free(s);
    free(path);
    free(text);
}

static void page_put_run(struct page *p, const char *dir, long room)
{
    p->most = ftell(p->out) + room;
    fputs("<section hidden class=\"run\" data-folder=\"", p->out);
    text_put(p->out, dir, TEXT_XML);
    fprintf(p->out, "\" data-process=\"%ld\">\n", folder_process(dir));
    put_whole(p, "summary.json");
    put_whole(p, "case.cfg");
    put_estimates(p, dir);
    page_put_table(p, "history.csv", room / 4);
    put_profiles(p, room / 2);
    put_picture(p);
    page_put_scene(p);
    for (int i = 0; i < p->left.n; i++)
        page_put_text(p, "left", p->left.text[i]);
    texts_free(&p->left);
    fputs("</section>\n", p->out);
}

/* What each key of a case means: path, meaning with its unit, source. */
static void put_keys(FILE *out)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    fputs("<pre hidden id=\"keys\">\n", out);
    SCHEMA_EACH (key, tables) {
        text_put(out, key->path, TEXT_XML);
        fputc('\t', out);
        text_put(out, key->what, TEXT_XML);
        fputc('\t', out);
        text_put(out, strcmp(key->unit, "-") != 0 ? key->unit : "", TEXT_XML);
        fputc('\t', out);
        text_put(out, key->source, TEXT_XML);
        fputc('\n', out);
    }
    fputs("</pre>\n", out);
}

/* What each equation says and where the book explains it; or what it is the
 * same as. */
static void put_equations(FILE *out)
{
    struct equation e;

    fputs("<pre hidden id=\"equations\">\n", out);
    for (const struct equation_index_row *r = equation_index_rows;
         r->key != NULL; r++) {
        const char *const kind = r->kind == EQUATION_INDEX_SAYS      ? "says"
                                 : r->kind == EQUATION_INDEX_AS      ? "as"
                                 : r->kind == EQUATION_INDEX_SECTION ? "section"
                                                                     : NULL;
        if (kind == NULL) continue;
        fprintf(out, "%s\t%s\t", r->key, kind);
        text_put(out, r->name, TEXT_XML);
        fprintf(out, "\t%s\n", r->file);
    }
    for (int i = 0; equations_at(i, &e); i++) {
        fprintf(out, "%s\tformula\t", e.key);
        text_put(out, e.formula, TEXT_XML);
        fputs("\t\n", out);
    }
    fputs("</pre>\n", out);
}

/* --- the page ------------------------------------------------------------- */

void page_put_program(FILE *out, const char *const *line)
{
    for (; *line != NULL; line++)
        fputs(*line, out);
}

static void put_runs(struct page *p, const int *folder, int n,
                     const char *const *dir)
{
    put_keys(p->out);
    put_equations(p->out);
    for (int i = 0; i < n; i++) {
        const long left = PAGE_MOST - PAGE_END - ftell(p->out);
        long script = 0;

        for (const char *const *line = page_js; *line != NULL; line++)
            script += (long)strlen(*line);
        p->folder = folder[i];
        page_put_run(p, dir[i], (left - script) / (n - i));
    }
}

/* The page as it stands in page.html, where @NAME is a part. */
static void page_put_all(struct page *p, const int *folder, int n,
                         const char *const *dir)
{
    static const struct {
        const char *name;
        const char *const *lines;
    } part[] = {{"@plots_css\n", page_plots_css},
                {"@css\n", page_css},
                {"@plots_js\n", page_plots_js},
                {"@scene_js\n", page_scene_js},
                {"@add_js\n", page_add_js},
                {"@js\n", page_js},
                {"@runs\n", NULL}};
    enum { PARTS = sizeof part / sizeof part[0] };

    for (const char *const *line = page_html; *line != NULL; line++) {
        int k = 0;
        while (k < PARTS && strcmp(*line, part[k].name) != 0)
            k++;
        if (k == PARTS)
            fputs(*line, p->out);
        else if (part[k].lines != NULL)
            page_put_program(p->out, part[k].lines);
        else
            put_runs(p, folder, n, dir);
    }
}

/* The folder of a run, open; -1 after a message. */
static int open_run(const char *dir)
{
    const int folder = open(dir, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    struct manifest m = {0};
    const int list =
        folder < 0 ? -1
                   : openat(folder, "manifest.txt",
                            O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    int wrong = list < 0;

    if (wrong)
        fprintf(stderr, "winnow: %s is not the folder of a run: %s\n", dir,
                folder < 0 ? strerror(errno) : "there is no manifest.txt");
    else {
        char *const path = file_join(dir, "manifest.txt");
        wrong = manifest_read(&m, list, path) != 0;
        free(path);
        manifest_release(&m);
        close(list);
    }
    if (!wrong) return folder;
    if (folder >= 0) close(folder);
    return -1;
}

static int page_write(const int *folder, int n, const char *const *dir)
{
    char *const path = file_join(dir[0], "report.html");
    struct file *const f = file_create(path);
    int code = 4;

    if (f != NULL) {
        struct page p = {.out = file_stream(f)};
        page_put_all(&p, folder, n, dir);
        if (file_commit(f) == 0) code = 0;
    }
    if (code == 0) printf("report %s\n", path);
    free(path);
    return code;
}

int report_pages(int n, const char *const *dir)
{
    int *const folder = alloc_ints(n);
    int opened = 0, code = 2;

    while (opened < n && (folder[opened] = open_run(dir[opened])) >= 0)
        opened++;
    if (opened == n) code = page_write(folder, n, dir);
    while (opened > 0)
        close(folder[--opened]);
    free(folder);
    return code;
}

static int report_act(const struct command_line *l)
{
    return report_pages(l->n_words, l->words);
}

const struct command report_command = {"report",
                                       "DIR [DIR ...]",
                                       "DIR/report.html, a page that shows the "
                                       "run, finished or not, and beside it "
                                       "those of further folders",
                                       "",
                                       1,
                                       -1,
                                       report_act};
