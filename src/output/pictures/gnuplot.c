/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/pictures/gnuplot.h"

#include "base/alloc.h"
#include "base/interrupt.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ; /* POSIX: the program declares it itself */

/* The exit code of a child that could not start gnuplot. */
enum { NO_PROGRAM = 127 };

/* Restores the signals of the child to their defaults, so that Ctrl-C ends a
 * gnuplot that hangs. */
static void set_signals(posix_spawnattr_t *how)
{
    sigset_t none, pipe;

    sigemptyset(&none);
    sigemptyset(&pipe);
    sigaddset(&pipe, SIGPIPE);
    posix_spawnattr_init(how);
    posix_spawnattr_setsigmask(how, &none);
    posix_spawnattr_setsigdefault(how, &pipe);
    posix_spawnattr_setflags(how,
                             POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
}

/* Waits for the end of the child; a signal to this program ends the child,
 * which may hang. */
static int status_of(pid_t child)
{
    const struct timespec nap = {0, 5000000}; /* 5 ms */
    pid_t ended;
    int status;

    while ((ended = waitpid(child, &status, WNOHANG)) == 0) {
        if (interrupt_arrived()) kill(child, SIGKILL);
        nanosleep(&nap, NULL);
    }
    return ended == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/* Runs the arguments as a command; its exit code, or -1 with errno if it could
 * not be started or did not end by itself. */
static int command_result(char *const arguments[], const char *log)
{
    posix_spawn_file_actions_t where;
    posix_spawnattr_t how;
    pid_t child;

    unlink(log);
    const int says =
        open(log, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (says < 0) return -1;
    (void)!write(says, GNUPLOT_SAYS, strlen(GNUPLOT_SAYS));
    set_signals(&how);
    posix_spawn_file_actions_init(&where);
    posix_spawn_file_actions_adddup2(&where, says, 1);
    posix_spawn_file_actions_adddup2(&where, says, 2);
    errno =
        posix_spawnp(&child, arguments[0], &where, &how, arguments, environ);
    posix_spawn_file_actions_destroy(&where);
    posix_spawnattr_destroy(&how);
    const int reason = errno;
    close(says);
    errno = reason;
    if (errno != 0) return -1;
    const int result = status_of(child);
    errno = EINTR;
    return result;
}

static int gnuplot_complaint(const struct gnuplot *g, int result, int reason)
{
    if ((result < 0 && reason == ENOENT) || result == NO_PROGRAM)
        fprintf(stderr,
                "winnow: no picture, for there is no gnuplot here; install it "
                "(Debian, Ubuntu: apt-get install gnuplot-nox) and run gnuplot "
                "%s in %s\n",
                g->script, g->folder);
    else if (result < 0)
        fprintf(stderr, "winnow: no picture: gnuplot in %s: %s\n", g->folder,
                strerror(reason));
    else
        fprintf(stderr,
                "winnow: no picture: gnuplot failed; it says why in %s/%s\n",
                g->folder, g->log);
    return 1;
}

/* The same, within the folder. */
static int drawn(const struct gnuplot *g)
{
    char *const partial = alloc_zeroed(strlen(g->png) + 9, 1);

    strcat(strcpy(partial, g->png), ".partial");
    char *const arguments[] = {"gnuplot",        "-c",    (char *)g->script,
                               (char *)g->above, partial, NULL};
    unlink(partial); /* which might be a link */
    const int result = command_result(arguments, g->log);
    int failed = 0;

    if (result != 0)
        failed = gnuplot_complaint(g, result, errno);
    else if (rename(partial, g->png) != 0)
        failed = gnuplot_complaint(g, -1, errno);
    if (failed) remove(partial);
    free(partial);
    return failed;
}

/* gnuplot is given plain names only, so the folder is the working directory for
 * the time of the call. */
int gnuplot_draw(const struct gnuplot *g)
{
    const int home = open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);

    if (home < 0 || chdir(g->folder) != 0) {
        gnuplot_complaint(g, -1, errno == ENOENT ? EIO : errno);
        if (home >= 0) close(home);
        return 1;
    }
    int failed = drawn(g);
    if (fchdir(home) != 0) failed = gnuplot_complaint(g, -1, errno);
    close(home);
    return failed;
}
