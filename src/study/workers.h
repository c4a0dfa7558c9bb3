/* workers.h -- processes of this program, started and waited for. */
#ifndef STUDY_WORKERS_H
#define STUDY_WORKERS_H

#include <sys/types.h>

/* Starts this program with the arguments, ended by NULL, the first its name;
 * what it says goes to the file `log`, anew. 0 with errno if it could not. */
pid_t workers_start(const char *const *arguments, const char *log);

/* The exit code of a process that has ended; -1 while it goes on. One that a
 * signal ended has 128 and the number of the signal. */
int workers_code(pid_t process);

#endif
