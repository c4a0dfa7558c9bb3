/* fuzz_run.h -- one run of the program in a scene, and what is wrong with it.
 *
 * The program runs in a child of this one, so that it may end as it likes: its
 * main is winnow_main here.
 */
#ifndef FUZZ_RUN_H
#define FUZZ_RUN_H

#include "fuzz_scene.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>

/* Limits of one run: of a long run until it is interrupted, of any by the
 * clock and on the processor [s]. The last two are for hanging programs on
 * busy machines, far above what any scene here takes. */
static const double patience = 0.3, longest = 60.0;
enum { PROCESSOR = 5 };

int winnow_main(int argc, char **argv);

/* Read by the sanitizers as they start. A request for memory beyond the limit
 * fails as on a small machine. */
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "exitcode=99:allocator_may_return_null=1:print_suppressions=0:max_"
           "allocation_size_mb=800";
}

/* libconfig forgets a string that never ends. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libconfig";
}

/* Splits the arguments at the ends of lines; an empty line is an empty one. */
static inline int split(char *text, char *argv[WORDS])
{
    int n = 1;

    argv[0] = "winnow";
    while (*text != '\0' && n < WORDS - 1) {
        char *const end = text + strcspn(text, "\n");
        argv[n++] = text;
        text = *end != '\0' ? end + 1 : end;
        *end = '\0';
    }
    argv[n] = NULL;
    return n;
}

/* 1 if the scene could write elsewhere than in its own folder: it names a path
 * from the root or upward, or the output folder "", which is the root. */
static inline int leaves_folder(const struct scene *s)
{
    static const char *const out[] = {"..",  "\"/", "=/",
                                      "\n/", "-o/", "-o\n\n"};

    for (int i = 0; i < s->n; i++)
        for (size_t k = 0; k < sizeof out / sizeof *out; k++)
            if (strstr(s->text[i].byte, out[k]) != NULL &&
                (i == 0 || strstr(s->file[i], ".cfg") != NULL))
                return 1;
    return 0;
}

/* The child: in the folder of the scene, with all it says in files beside. */
static inline void act(const struct scene *s, const char *dir)
{
    static const char *const stream[] = {"/dev/null", "out", "err"};
    char *argv[WORDS];

    for (int i = 0; i < 3; i++) {
        const int f = open(i == 0 ? stream[0] : path_of(dir, stream[i]).text,
                           O_RDWR | (i > 0 ? O_CREAT | O_TRUNC : 0), 0666);
        dup2(f, i);
        close(f);
    }
    setrlimit(RLIMIT_CPU, &(struct rlimit){PROCESSOR, PROCESSOR + 2});
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){1 << 25, 1 << 25});
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    signal(SIGXFSZ, SIG_IGN);
    setenv("PATH", "/nowhere", 1); /* no gnuplot: pictures take long */
    if (chdir(path_of(dir, "in").text) != 0) _exit(98);
    exit(winnow_main(split(s->text[0].byte, argv), argv));
}

static inline double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Its status; a run that takes long is interrupted, then killed. */
static inline int await(pid_t child, int is_run, int *interrupted)
{
    const double start = seconds();
    int status;

    *interrupted = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        nanosleep(&(struct timespec){0, 500000}, NULL);
        if (is_run && !*interrupted && seconds() - start > patience)
            *interrupted = kill(child, SIGINT) == 0;
        if (seconds() - start > longest) kill(child, SIGKILL);
    }
    return status;
}

/* Those of the program, of which the usage is one; that there is no gnuplot is
 * the fuzzer's doing. */
static inline int count_messages(const char *said)
{
    int n = strstr(said, "there is no gnuplot here") != NULL ? -1 : 0;

    for (; (said = strstr(said, "innow: ")) != NULL; said++)
        n++;
    return n;
}

/* 1 if a result is no number. */
static inline int has_nan(const char *said)
{
    for (; (said = strpbrk(said, " =")) != NULL; said++) {
        const char *const word = said + 1 + strspn(said + 1, "-");
        if (strncmp(word, "nan", 3) == 0 && strchr(" ,;%\n", word[3]) != NULL)
            return 1;
    }
    return 0;
}

/* The first place of ours in what a sanitizer or assert says. */
static inline void name_place(const char *said, char *where, size_t room)
{
    const char *at = strstr(said, "src/");

    while (at != NULL && at > said && at[-1] == '/')
        at = strstr(at + 1, "src/");
    if (strstr(said, "runtime error") == NULL &&
        strstr(said, "Sanitizer") == NULL && strstr(said, "ssertion") == NULL)
        at = NULL;
    if (at != NULL)
        snprintf(where, room, "%.*s", (int)strcspn(at, " )\n"), at);
    else
        snprintf(where, room, "nowhere");
}

/* Fills what is wrong with the way it ended, "" if nothing. */
static inline void judge(const struct scene *s, const char *dir, int status,
                         int interrupted, char wrong[NAME])
{
    const struct text said = read_text(path_of(dir, "err").text);
    const struct text result = read_text(path_of(dir, "out").text);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    char where[NAME / 2];

    wrong[0] = '\0';
    name_place(said.byte, where, sizeof where);
    if (WIFSIGNALED(status) && !(WTERMSIG(status) == SIGINT && interrupted))
        snprintf(wrong, NAME, "signal-%d at %s", WTERMSIG(status), where);
    else if (code > 0 && (code < 2 || code > 4) &&
             !(code == 130 && interrupted))
        snprintf(wrong, NAME, "exit-%d at %s", code, where);
    else if (code >= 2 && code <= 4 && count_messages(said.byte) != 1)
        snprintf(wrong, NAME, "exit-%d with %d messages", code,
                 count_messages(said.byte));
    else if (code == 0 && has_nan(result.byte))
        snprintf(wrong, NAME, "exit-0 with a result that is no number");
    free(said.byte);
    free(result.byte);
    for (int i = 0; i < s->n && code == 2; i++)
        unlink(path_of(path_of(dir, "in").text, s->file[i]).text);
    if (code == 2 && rmdir(path_of(dir, "in").text) != 0 && wrong[0] == '\0')
        snprintf(wrong, NAME, "exit-2 and something left");
}

/* Runs a scene in DIR/in; wrong is "" if all is well. */
static inline void try_scene(const struct scene *s, const char *dir,
                             char wrong[NAME])
{
    const int is_run = strncmp(s->text[0].byte, "run", 3) == 0;
    int interrupted;

    clear_folder(path_of(dir, "in").text);
    scene_save(s, path_of(dir, "in").text);
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) act(s, dir);
    const int status = await(child, is_run, &interrupted);
    judge(s, dir, status, interrupted, wrong);
}

#endif
