/* SPDX-License-Identifier: GPL-3.0-or-later */
/* new.c -- the cases that come with the program: `winnow list cases`, and
 * `winnow new`: a copy of one, with all files that it needs. */
#include "tell/check.h"

#include <ctype.h>
#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/text.h"
#include "case/case_file.h"
#include "case/checks/checks.h"
#include "case/command.h"

/* The case to begin with if no other one is named. */
#define FIRST "small-bed"
static const char look_at[] = "What to look at: ";

enum { PATH_TEXT = 4096, LINE_TEXT = 200 };

/* The cases that are installed with the program, or lie beside its build, or
 * here. Non-zero if there are none. */
static int shipped_find(glob_t *found)
{
    static const char *const folders[] = {"/../share/winnow/cases", "/../cases",
                                          "./cases"};
    char program[PATH_TEXT] = "", path[2 * PATH_TEXT];

    if (readlink("/proc/self/exe", program, sizeof program - 1) < 0)
        program[0] = '\0';
    if (strrchr(program, '/') != NULL) *strrchr(program, '/') = '\0';
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        const int here = folders[i][0] == '.';

        snprintf(path, sizeof path, "%s%s/*.cfg", here ? "" : program,
                 folders[i]);
        if (glob(path, 0, NULL, found) == 0) return 0;
    }
    return 1;
}

static int none(void)
{
    fprintf(stderr, "winnow: no cases in ../share/winnow/cases or ../cases "
                    "beside the program, nor in ./cases\n");
    return 4;
}

/* "small-bed" of "there/small-bed.cfg". */
static void shipped_name_of(const char *path, char name[LINE_TEXT])
{
    const char *const slash = strrchr(path, '/');

    snprintf(name, LINE_TEXT, "%s", slash != NULL ? slash + 1 : path);
    if (strrchr(name, '.') != NULL) *strrchr(name, '.') = '\0';
}

/* What the comment at the head says to look at, to the end of a clause. */
static void purpose(const char *text, char line[LINE_TEXT])
{
    const char *c = strstr(text, look_at);
    size_t n = 0;

    if (c != NULL) c += strlen(look_at);
    for (; c != NULL && *c != '\0' && n + 1 < LINE_TEXT; c++) {
        if (strchr(".;", *c) != NULL && isspace((unsigned char)c[1]) &&
            !isdigit((unsigned char)c[2])) /* "Fig. 3" */
            break;
        if (*c == '\n' && strncmp(c, "\n# ", 3) != 0) break;
        line[n++] = iscntrl((unsigned char)*c) ? ' ' : *c;
        if (*c == '\n') c += 2;
    }
    line[n] = '\0';
}

static void shipped_print_case(const char *path, const struct settings *s)
{
    const struct case_scales k = case_scales_of(s);
    char name[LINE_TEXT], line[LINE_TEXT];

    shipped_name_of(path, name);
    purpose(input_kept(settings_files(s), s->file)->text, line);
    printf("%-22s %6d cells %6d particles  %s%s%s\n", name, k.cells,
           k.particles, s->title, line[0] != '\0' ? ". Look at: " : "", line);
}

int list_cases(void)
{
    glob_t found;
    int code = 0;

    if (shipped_find(&found) != 0) return none();
    for (size_t i = 0; i < found.gl_pathc && code == 0; i++) {
        const char *const path = found.gl_pathv[i];
        struct settings *const s = case_file_read(path, 0, NULL, &code);

        if (s != NULL) shipped_print_case(path, s);
        settings_free(s);
    }
    globfree(&found);
    return code;
}

/* The path of the shipped case of that name. The exit code. */
static int find_named(const char *name, char path[PATH_TEXT])
{
    char other[LINE_TEXT], hint[NEAREST_HINT];
    struct nearest n;
    glob_t found;

    if (shipped_find(&found) != 0) return none();
    nearest_init(&n, name);
    path[0] = '\0';
    for (size_t i = 0; i < found.gl_pathc; i++) {
        shipped_name_of(found.gl_pathv[i], other);
        nearest_offer(&n, other);
        if (strcmp(name, other) == 0)
            snprintf(path, PATH_TEXT, "%s", found.gl_pathv[i]);
    }
    globfree(&found);
    if (path[0] != '\0') return 0;
    fprintf(stderr, "winnow: no case %s%s\n", name,
            nearest_hint(nearest_best(&n), "; winnow list cases names them all",
                         hint));
    return 2;
}

/* The files that a case needs: itself, and what it names in quotes. */
enum { PARTS = 64 };
struct parts {
    const char *from; /* the folder of all of them */
    const char *to;   /* the new path of the first */
    struct input in[PARTS];
    char path[PARTS][PATH_TEXT]; /* where they are to be */
    int n;
};

static void parts_add(struct parts *p, const char *name);

/* Adds what a text names in quotes and not in a comment. */
static void parts_add_named(struct parts *p, const char *text)
{
    char name[LINE_TEXT];

    while (*(text += strcspn(text, "#\"")) != '\0') {
        if (*text == '"') {
            const int n = (int)strcspn(++text, "\"\n");
            snprintf(name, sizeof name, "%.*s", n, text);
            if (n > 0) parts_add(p, name);
            text += n + (text[n] == '"');
        } else {
            text += strcspn(text, "\n");
        }
    }
}

/* Adds the file of that name, with those that it names, or those of the folder
 * of that name; nothing if there is none, or if it is among them. */
static void parts_add(struct parts *p, const char *name)
{
    const char *const slash = strrchr(p->to, '/');
    const int beside = slash == NULL ? 0 : (int)(slash + 1 - p->to);
    char *const from = file_join(p->from, name);
    char *const all = file_join(from, "*");
    glob_t inside;
    int known = p->n == PARTS;

    for (int i = 0; i < p->n; i++)
        known |= strcmp(p->in[i].path, from) == 0;
    if (!known && glob(all, 0, NULL, &inside) == 0) {
        for (size_t i = 0; i < inside.gl_pathc; i++)
            parts_add(p, inside.gl_pathv[i] + strlen(p->from) + 1);
        globfree(&inside);
    } else if (!known && input_wrong(from) == NULL) {
        p->in[p->n] = input_of(from);
        if (p->n == 0)
            snprintf(p->path[0], PATH_TEXT, "%s", p->to);
        else
            snprintf(p->path[p->n], PATH_TEXT, "%.*s%s", beside, p->to, name);
        if (p->in[p->n++].text != NULL)
            parts_add_named(p, p->in[p->n - 1].text);
    }
    free(all);
    free(from);
}

/* 1 if there is a file that is not as it should be: a case is always new. */
static int parts_in_the_way(const struct parts *p, int i)
{
    struct input old = input_of(p->path[i]);
    const int same = i > 0 && old.text != NULL && p->in[i].text != NULL &&
                     old.length == p->in[i].length &&
                     memcmp(old.text, p->in[i].text, old.length) == 0;

    input_release(&old);
    if (same || access(p->path[i], F_OK) != 0) return 0;
    fprintf(stderr, "winnow: %s: cannot make it: %s\n", p->path[i],
            strerror(EEXIST));
    return 1;
}

static int parts_write(const struct parts *p, int i)
{
    char folder[PATH_TEXT];

    snprintf(folder, sizeof folder, "%s", p->path[i]);
    if (i > 0 && strrchr(folder, '/') != NULL) {
        *strrchr(folder, '/') = '\0';
        if (file_make_dirs(folder) != 0) return 1;
    }
    return file_write(p->path[i], p->in[i].text, p->in[i].length);
}

/* All or none, the case last. The exit code. */
static int parts_copy(const struct parts *p)
{
    int wrong = 0;

    for (int i = p->n - 1; i >= 0 && !wrong; i--)
        if ((wrong = p->in[i].text == NULL))
            fprintf(stderr, "winnow: %s: cannot read: %s\n", p->in[i].path,
                    p->in[i].why);
    for (int i = p->n - 1; i >= 0 && !wrong; i--)
        wrong = parts_in_the_way(p, i);
    for (int i = p->n - 1; i >= 0 && !wrong; i--)
        wrong = parts_write(p, i);
    return wrong ? 4 : 0;
}

static int shipped_act(const struct command_line *l)
{
    const char *const name = l->words[0];
    const char *const from = l->n_words > 1 ? l->words[1] : FIRST;
    const char *const end = strrchr(name, '.');
    char path[PATH_TEXT], to[PATH_TEXT];
    struct parts *const p = alloc_zeroed(1, sizeof *p);
    int code = find_named(from, path);

    snprintf(to, sizeof to, "%s%s", name,
             end != NULL && strcmp(end, ".cfg") == 0 ? "" : ".cfg");
    if (code == 0) {
        char *const slash = strrchr(path, '/');
        *slash = '\0';
        *p = (struct parts){.from = path, .to = to};
        parts_add(p, slash + 1);
        code = parts_copy(p);
    }
    if (code == 0) {
        printf("%s: as %s\n", to, from);
        for (int i = 1; i < p->n; i++)
            printf("%s: beside it\n", p->path[i]);
        printf("  winnow check %s\n  winnow run %s\n", to, to);
    }
    for (int i = 0; i < p->n; i++)
        input_release(&p->in[i]);
    free(p);
    return code;
}

const struct command list_new_command = {
    "new",
    "NAME [FROM]",
    "NAME.cfg, a case to begin with: a small bed, or a copy of FROM, one of "
    "`winnow list cases`",
    "",
    1,
    2,
    shipped_act};
