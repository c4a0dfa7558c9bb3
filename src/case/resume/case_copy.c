/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resume/case_copy.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/file.h"
#include "base/text.h"
#include "case/resume/case_text.h"

/* A file that the case names. */
struct named_file {
    const struct input *in; /* borrowed from the settings */
    char *name;             /* "case/NAME", in the folder of the run */
};

struct case_copy {
    const struct settings *settings;
    char *case_text; /* of case.cfg */
    int n, capacity;
    struct named_file *file;
};

/* --- reading -------------------------------------------------------------- */

static int has_name(const struct case_copy *c, const char *name)
{
    for (int i = 0; i < c->n; i++)
        if (strcmp(c->file[i].name, name) == 0) return 1;
    return 0;
}

/* Two files of one name from two folders: the second gets a number. */
static char *free_name(const struct case_copy *c, const char *path)
{
    const char *const slash = strrchr(path, '/');
    const char *const last = slash != NULL ? slash + 1 : path;
    char *const name = alloc_zeroed(strlen(last) + 24, 1);

    sprintf(name, "case/%s", last);
    for (int k = 2; has_name(c, name); k++)
        sprintf(name, "case/%d-%s", k, last);
    return name;
}

static void add_file(void *of, const struct input *in)
{
    struct case_copy *const c = of;

    for (int i = 0; i < c->n; i++)
        if (c->file[i].in == in) return;
    if (c->n == c->capacity) {
        struct named_file *const more =
            alloc_zeroed(2 * (size_t)c->n + 8, sizeof *more);
        if (c->n > 0) memcpy(more, c->file, (size_t)c->n * sizeof *more);
        free(c->file);
        c->file = more;
        c->capacity = 2 * c->n + 8;
    }
    char *const name = free_name(c, in->path);
    c->file[c->n++] = (struct named_file){in, name};
}

/* The name of a file in case.cfg. */
static char *named(void *of, const struct key *row, const char *name)
{
    struct case_copy *const c = of;
    int i = 0;

    case_text_each_file(c->settings, row, name, add_file, c);
    if (row->mark & KEY_FOLDER) return strdup("case");
    while (c->file[i].in != settings_input(c->settings, name))
        i++;
    return strdup(c->file[i].name);
}

struct case_copy *case_copy_create(const struct settings *s,
                                   const struct run_options *o)
{
    struct case_copy *const c = alloc_zeroed(1, sizeof *c);
    size_t length;
    FILE *const out = open_memstream(&c->case_text, &length);

    c->settings = s;
    fprintf(out,
            "# The case of this run, by winnow " VERSION_TEXT
            ", from %s.\n# `winnow run case.cfg` repeats it.",
            settings_file(s));
    for (int i = 0; i < o->n_overrides; i++)
        fprintf(out, "%s -s %s", i == 0 ? " It was run with" : "",
                o->overrides[i]);
    fputs("\n\n", out);
    case_text_write(s, out, named, c);
    fclose(out);
    return c;
}

void case_copy_free(struct case_copy *c)
{
    if (c == NULL) return;
    for (int i = 0; i < c->n; i++)
        free(c->file[i].name);
    free(c->file);
    free(c->case_text);
    free(c);
}

/* --- writing -------------------------------------------------------------- */

static int write_at(const char *path, const char *text, size_t length)
{
    struct file *const f = file_create(path);

    if (f == NULL) return 1;
    fwrite(text, 1, length, file_stream(f));
    return file_commit(f);
}

static int write_text(struct folder *folder, const char *name, const char *text,
                      size_t length)
{
    char *const path = folder_file(folder, name);
    const int failed = path == NULL || write_at(path, text, length) != 0;

    free(path);
    return failed;
}

/* The file of a bed that the run itself has written is not copied. The case
 * goes first, for it tells which files in its folder are of the run. */
int case_copy_write(struct case_copy *c, struct folder *folder)
{
    int failed = write_text(folder, "case.cfg", c->case_text,
                            strlen(c->case_text)) != 0 ||
                 (c->n > 0 && folder_make(folder, "case") != 0);

    for (int i = 0; i < c->n && !failed; i++) {
        const struct input *const in =
            input_kept(settings_files(c->settings), c->file[i].in->path);
        if (in->text != NULL)
            failed = write_text(folder, c->file[i].name, in->text, in->length);
    }
    return failed;
}

/* The case without the remark above it. */
static const char *body(const char *text)
{
    const char *const blank = strstr(text, "\n\n");
    return blank != NULL ? blank : text;
}

/* 1 if the file is there, and says the same if there is a text. */
static int is_there(const char *path, const char *text)
{
    const char *why;
    size_t length;
    char *const old = input_text(path, &length, &why);
    const int same =
        old != NULL && (text == NULL || strcmp(body(old), body(text)) == 0);

    free(old);
    return same;
}

int case_copy_restore(struct case_copy *c, const char *dir)
{
    char *const of_case = file_join(dir, "case.cfg");
    int failed = 0;

    for (int i = 0; i < c->n && !failed; i++) {
        char *const path = file_join(dir, c->file[i].name);
        const struct input *const in = c->file[i].in;
        if (in->text != NULL && !is_there(path, NULL))
            failed = write_at(path, in->text, in->length);
        free(path);
    }
    if (!failed && !is_there(of_case, c->case_text))
        failed = write_at(of_case, c->case_text, strlen(c->case_text));
    free(of_case);
    return failed;
}
