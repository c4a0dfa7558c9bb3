/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/gnuplot.h"

#include "base/alloc.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

extern char **environ; /* POSIX: the program declares it itself */

/* Runs the arguments as a command; its exit code, or -1 with errno if it could
 * not be started or did not end by itself. */
static int command_result(char *const arguments[], const char *log)
{
    posix_spawn_file_actions_t where;
    pid_t child;
    int status = 0;

    posix_spawn_file_actions_init(&where);
    posix_spawn_file_actions_addopen(&where, 1, log,
                                     O_WRONLY | O_CREAT | O_TRUNC, 0666);
    posix_spawn_file_actions_adddup2(&where, 1, 2);
    errno =
        posix_spawnp(&child, arguments[0], &where, NULL, arguments, environ);
    posix_spawn_file_actions_destroy(&where);
    if (errno != 0) return -1;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    errno = EINTR;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* 127 is how a started process says that there was nothing to run. */
static int complaint(int result, int reason, const char *png,
                     const char *script, const char *log)
{
    if ((result < 0 && reason == ENOENT) || result == 127)
        fprintf(stderr,
                "winnow: no %s, for there is no gnuplot here; install it "
                "(Debian, Ubuntu: apt-get install gnuplot-nox) and run "
                "gnuplot -c %s\n",
                png, script);
    else if (result < 0)
        fprintf(stderr, "winnow: no %s: gnuplot: %s\n", png, strerror(reason));
    else
        fprintf(stderr, "winnow: no %s: gnuplot failed; it says why in %s\n",
                png, log);
    return 1;
}

int gnuplot_draw(const char *script, const char *dir, const char *png,
                 const char *log)
{
    char *const partial = alloc_zeroed(strlen(png) + 9, 1);

    strcat(strcpy(partial, png), ".partial");
    char *const arguments[] = {"gnuplot",   "-c",    (char *)script,
                               (char *)dir, partial, NULL};
    const int result = command_result(arguments, log);
    int failed = 0;

    if (result != 0)
        failed = complaint(result, errno, png, script, log);
    else if (rename(partial, png) != 0)
        failed = complaint(-1, errno, png, script, log);
    if (failed) remove(partial);
    free(partial);
    return failed;
}
