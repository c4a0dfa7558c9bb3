/* poly_file.h -- the words and numbers of one file of an OpenFOAM mesh.
 *
 * A file is a header in braces and a list, N ( ... ), between comments. Each
 * function reads the next item. The first error is reported on stderr with file
 * and line; then `failed` is set and every further item reads as 0.
 */
#ifndef MESH_POLY_POLY_FILE_H
#define MESH_POLY_POLY_FILE_H

#include "base/file.h"

enum { POLY_WORD = 128 };

struct poly_file {
    char path[1024];
    const char *text; /* all of the file, borrowed from those that were read */
    struct inputs *own; /* where it is, if it is not kept */
    char *unpacked;     /* or made of it; NULL: it is not packed */
    long size;          /* [byte] */
    long at;            /* [-] the next character */
    int line;           /* [-] counted from 1 */
    int failed;
    int is_binary;     /* [-] 1: lists of numbers are bytes in brackets */
    int is_compact;    /* [-] 1: faces are where each begins, and all corners */
    int label, scalar; /* [byte] of a whole number and of a real one there */
    int in_bytes;      /* [-] 1: within such a list */
    long same; /* [-] where the number of a list of equal ones is, N{0}; or 0 */
};

/* Reads the file dir/name, or dir/name.gz, and its header. */
void poly_file_open(struct poly_file *p, struct inputs **files, const char *dir,
                    const char *name);
void poly_file_close(struct poly_file *p);

/* The next word, which ends before a blank or a sign; each of the signs ( ) { }
 * ; is a word of its own, and a text in quotes is one. */
void poly_file_word(struct poly_file *p, char word[POLY_WORD]);
void poly_file_expect(struct poly_file *p, const char *word);
int poly_file_int(struct poly_file *p);
/* The brackets around the n numbers of a list, which are words or bytes, or of
 * whole numbers one in braces for all. */
void poly_file_begin(struct poly_file *p, int n);
void poly_file_end(struct poly_file *p, int n);
/* The number of entries of a list: no more than the file can contain with
 * `least` characters or more each, and such that four times it is an int. With
 * 0 the caller limits it, as N{0} has one number for all entries. */
int poly_file_count(struct poly_file *p, int least);
double poly_file_real(struct poly_file *p);

/* Reports an error at the present line and sets `failed`. */
void poly_file_wrong(struct poly_file *p, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
