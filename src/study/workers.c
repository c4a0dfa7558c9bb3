/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/workers.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stddef.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ; /* POSIX: the program declares it itself */

/* The file of the running program under Linux, also after it was built anew. */
static const char myself[] = "/proc/self/exe";

pid_t workers_start(const char *const *arguments, const char *log)
{
    posix_spawn_file_actions_t where;
    pid_t process = 0;

    unlink(log); /* which might be a link */
    posix_spawn_file_actions_init(&where);
    posix_spawn_file_actions_addopen(
        &where, 1, log, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, 0666);
    posix_spawn_file_actions_adddup2(&where, 1, 2);
    errno = posix_spawn(&process, myself, &where, NULL,
                        (char *const *)(size_t)arguments, environ);
    if (errno == ENOENT)
        errno = posix_spawnp(&process, arguments[0], &where, NULL,
                             (char *const *)(size_t)arguments, environ);
    posix_spawn_file_actions_destroy(&where);
    return errno == 0 ? process : 0;
}

int workers_code(pid_t process)
{
    int status;

    if (waitpid(process, &status, WNOHANG) != process) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
