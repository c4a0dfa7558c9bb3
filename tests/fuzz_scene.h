/* fuzz_scene.h -- a scene of the fuzzer: a folder of files.
 *
 * The file `arguments` has one argument of the command line a line; the others
 * are what it names.
 */
#ifndef FUZZ_SCENE_H
#define FUZZ_SCENE_H

#include "mutate.h"

#include <dirent.h>
#include <limits.h>
#include <sys/stat.h>
#include <unistd.h>

enum { FILES = 12, NAME = 300, WORDS = 64 };

struct scene {
    char name[NAME];
    int n; /* files; the first is `arguments` */
    char file[FILES][NAME];
    struct text text[FILES];
};

/* Names of files, by value. */
struct path {
    char text[PATH_MAX];
};

static inline struct path path_of(const char *dir, const char *name)
{
    struct path p;

    snprintf(p.text, PATH_MAX, "%.2000s/%.2000s", dir, name);
    return p;
}

/* The beginning of a file; nothing if it cannot be read. */
static inline struct text read_text(const char *path)
{
    FILE *const in = fopen(path, "rb");
    struct stat info;
    struct text t = {NULL, 0};

    if (in == NULL || fstat(fileno(in), &info) != 0) return text_of("", 0);
    t.n = info.st_size < MUTATE_MOST ? (size_t)info.st_size : MUTATE_MOST;
    t.byte = malloc(t.n + 1);
    t.n = fread(t.byte, 1, t.n, in);
    t.byte[t.n] = '\0';
    fclose(in);
    return t;
}

static inline int by_name(const void *a, const void *b)
{
    return strcmp(a, b);
}

/* The names in a folder, in order. */
static inline int names_in(const char *dir, int most, char (*name)[NAME])
{
    DIR *const list = opendir(dir);
    int n = 0;

    for (struct dirent *e; list != NULL && (e = readdir(list)) != NULL;)
        if (strcmp(e->d_name, ".") != 0 && strcmp(e->d_name, "..") != 0 &&
            n < most)
            snprintf(name[n++], NAME, "%s", e->d_name);
    if (list != NULL) closedir(list);
    qsort(name, (size_t)n, NAME, by_name);
    return n;
}

static inline struct scene scene_load(const char *dir)
{
    const char *const slash = strrchr(dir, '/');
    struct scene s = {.n = 0};

    snprintf(s.name, NAME, "%.100s", slash != NULL ? slash + 1 : dir);
    s.n = names_in(dir, FILES, s.file);
    for (int i = 0; i < s.n; i++)
        s.text[i] = read_text(path_of(dir, s.file[i]).text);
    if (s.n > 0 && strcmp(s.file[0], "arguments") == 0) return s;
    fprintf(stderr, "fuzz: %s: no scene\n", dir);
    exit(1);
}

static inline struct scene scene_copy(const struct scene *from)
{
    struct scene s = *from;

    for (int i = 0; i < s.n; i++)
        s.text[i] = text_of(from->text[i].byte, from->text[i].n);
    return s;
}

static inline void scene_free(struct scene *s)
{
    for (int i = 0; i < s->n; i++)
        free(s->text[i].byte);
}

static inline void scene_save(const struct scene *s, const char *dir)
{
    mkdir(dir, 0777);
    for (int i = 0; i < s->n; i++) {
        FILE *const out = fopen(path_of(dir, s->file[i]).text, "wb");
        if (out == NULL) continue;
        fwrite(s->text[i].byte, 1, s->text[i].n, out);
        fclose(out);
    }
}

static inline void clear_folder(const char *dir)
{
    char name[64][NAME];
    int n;

    do {
        n = names_in(dir, 64, name);
        for (int i = 0; i < n; i++) {
            const struct path path = path_of(dir, name[i]);
            if (unlink(path.text) != 0) clear_folder(path.text);
        }
    } while (n == 64);
    rmdir(dir);
}

#endif
