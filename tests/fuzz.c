/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fuzz.c -- the program fed with broken input.
 *
 *   fuzz replay FOLDER...                 each scene as it is
 *   fuzz search SEED SECONDS OUT FOLDER   scenes of the folder, changed
 *
 * Whatever a scene holds, the program ends by itself with 0, 2, 3 or 4, says
 * exactly one thing where it fails, and leaves nothing behind where it refuses.
 * The search changes one to six places of a scene, shortens what it finds, and
 * writes it to OUT. Round k of a seed is the same each time.
 */
#include "base/key.h"
#include "case/case_file.h"
#include "case/schema.h"
#include "fuzz_run.h"

enum { SCENES = 400 };

/* --- the search ------------------------------------------------------------
 */

/* One more option -s with a key that there is. */
static void change_setting(struct scene *s, gsl_rng *r)
{
    const struct key *tables[CASE_FILE_TABLES], *key = NULL;
    char option[1024], path[SCHEMA_TEXT];
    int n = 0;

    case_file_tables(tables);
    SCHEMA_EACH (k, tables)
        n++;
    n = (int)mutate_below(r, (size_t)n);
    SCHEMA_EACH (k, tables)
        if (n-- == 0) key = k;
    snprintf(path, sizeof path, "%s", key->path);
    for (char *p; (p = strstr(path, "<patch>")) != NULL;)
        memcpy(p, "top    ", 7), memmove(p + 3, p + 7, strlen(p + 7) + 1);
    const char *const word = mutate_below(r, 2) ? MUTATE_ANY(mutate_numbers, r)
                                                : MUTATE_ANY(mutate_words, r);
    snprintf(option, sizeof option, "-s\n%s=%s\n", path,
             mutate_below(r, 4) == 0 ? key->allowed : word);
    text_replace(&s->text[0], s->text[0].n, s->text[0].n, option,
                 strlen(option));
}

/* Half of the scenes stay well-formed: only numbers and settings change. */
static void change_scene(struct scene *s, const struct scene *other, gsl_rng *r)
{
    const int tame = (int)mutate_below(r, 2);

    for (size_t n = 1 + mutate_below(r, 1 + mutate_below(r, 6)); n > 0; n--) {
        const size_t i = mutate_below(r, (size_t)s->n);
        const size_t j = mutate_below(r, (size_t)other->n);
        if (i == 0 && mutate_below(r, 2))
            change_setting(s, r);
        else if (tame)
            change_number(&s->text[i], r);
        else
            mutate(&s->text[i], &other->text[i > 0 && j > 0 ? j : 0], r);
    }
}

/* Takes lines away as long as the same is wrong, for a few seconds. */
static void shorten(struct scene *s, const char *dir, const char *wrong)
{
    const double start = seconds();
    char found[NAME];

    for (int i = 0; i < s->n; i++)
        for (size_t at = 0;
             at < s->text[i].n && seconds() - start < PROCESSOR;) {
            struct scene less = scene_copy(s);
            const size_t end = at + strcspn(s->text[i].byte + at, "\n") + 1;
            text_replace(&less.text[i], at,
                         end < s->text[i].n ? end : s->text[i].n, "", 0);
            try_scene(&less, dir, found);
            if (strcmp(found, wrong) == 0) {
                scene_free(s);
                *s = less;
                continue;
            }
            scene_free(&less);
            at = end;
        }
}

static void report(struct scene *s, const char *dir, unsigned long seed,
                   unsigned long round, const char *wrong, const char *program)
{
    char name[NAME];

    shorten(s, dir, wrong);
    snprintf(name, NAME, "%.60s-%lu-%lu", s->name, seed, round);
    scene_save(s, path_of(dir, name).text);
    printf("%s: %s\n    %s replay %s\n", name, wrong, program,
           path_of(dir, name).text);
    fflush(stdout);
}

static int search(unsigned long seed, double most, const char *dir,
                  const char *corpus, const char *program)
{
    static struct scene scene[SCENES];
    static char name[SCENES][NAME], known[SCENES][NAME];
    const int n = names_in(corpus, SCENES, name);
    const double start = seconds();
    gsl_rng *const r = gsl_rng_alloc(gsl_rng_mt19937);
    unsigned long round = 0;
    int found = 0;

    for (int i = 0; i < n; i++)
        scene[i] = scene_load(path_of(corpus, name[i]).text);
    mkdir(dir, 0777);
    for (; n > 0 && found < SCENES && seconds() - start < most; round++) {
        char wrong[NAME];
        int old = 0;
        gsl_rng_set(r, seed * 1000003 + round);
        struct scene s = scene_copy(&scene[mutate_below(r, (size_t)n)]);
        change_scene(&s, &scene[mutate_below(r, (size_t)n)], r);
        wrong[0] = '\0';
        if (!leaves_folder(&s)) try_scene(&s, dir, wrong);
        for (int i = 0; i < found; i++)
            old |= strcmp(known[i], wrong) == 0;
        if (wrong[0] != '\0' && !old) {
            strcpy(known[found++], wrong);
            report(&s, dir, seed, round, wrong, program);
        }
        scene_free(&s);
    }
    printf("fuzz: seed %lu, %lu rounds over %d scenes, %d things found\n", seed,
           round, n, found);
    gsl_rng_free(r);
    return found > 0;
}

static int replay(int n, char **dir)
{
    char work[] = "/tmp/winnow-fuzz-XXXXXX", wrong[NAME];
    int failed = 0;

    if (mkdtemp(work) == NULL) return 1;
    for (int i = 0; i < n; i++) {
        struct scene s = scene_load(dir[i]);
        try_scene(&s, work, wrong);
        if (wrong[0] != '\0' || n == 1) {
            const struct text said = read_text(path_of(work, "err").text);
            printf("%s: %s\n%s", dir[i], wrong[0] ? wrong : "as it should be",
                   said.byte);
            free(said.byte);
        }
        failed += wrong[0] != '\0';
        scene_free(&s);
    }
    clear_folder(work);
    printf("scenes of the fuzzer: %d passed, %d failed\n", n - failed, failed);
    return failed > 0;
}

int main(int argc, char **argv)
{
    if (argc > 2 && strcmp(argv[1], "replay") == 0)
        return replay(argc - 2, argv + 2);
    if (argc == 6 && strcmp(argv[1], "search") == 0)
        return search(strtoul(argv[2], NULL, 10), atof(argv[3]), argv[4],
                      argv[5], argv[0]);
    fprintf(stderr, "fuzz replay FOLDER... | search SEED SECONDS OUT FOLDER\n");
    return 1;
}
