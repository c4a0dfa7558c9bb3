/* capture.h -- the output of a function on stderr or stdout, for tests. */
#ifndef CAPTURE_H
#define CAPTURE_H

#include <stdio.h>
#include <unistd.h>

enum { CAPTURE_TEXT = 65536 };

struct capture {
    int descriptor, kept;
    FILE *file;
};

/* Redirects the descriptor (1 or 2) to a temporary file. */
static inline struct capture capture_begin(int descriptor)
{
    struct capture c = {descriptor, dup(descriptor), tmpfile()};

    fflush(stdout);
    dup2(fileno(c.file), descriptor);
    return c;
}

/* Restores the descriptor; text receives what was written meanwhile. */
static inline void capture_end(struct capture *c, char text[CAPTURE_TEXT])
{
    size_t n;

    fflush(stdout);
    fflush(stderr);
    dup2(c->kept, c->descriptor);
    close(c->kept);
    rewind(c->file);
    n = fread(text, 1, CAPTURE_TEXT - 1, c->file);
    text[n] = '\0';
    fclose(c->file);
}

#endif
