/* poly_file.h -- the words and numbers of one file of an OpenFOAM mesh.
 *
 * A file is a header in braces and a list, N ( ... ), between comments. Each
 * function reads the next item. The first error is reported on stderr with file
 * and line; then `failed` is set and every further item reads as 0.
 */
#ifndef MESH_POLY_POLY_FILE_H
#define MESH_POLY_POLY_FILE_H

enum { POLY_WORD = 128 };

struct poly_file {
    char path[1024];
    char *text; /* all of the file */
    long size;  /* [byte] */
    long at;    /* [-] the next character */
    int line;   /* [-] counted from 1 */
    int failed;
};

/* Reads the file dir/name, or dir/name.gz, and its header; format must be
 * ascii. */
void poly_file_open(struct poly_file *p, const char *dir, const char *name);
void poly_file_close(struct poly_file *p);

/* The next word, which ends before a blank or a sign; each of the signs ( ) { }
 * ; is a word of its own. */
void poly_file_word(struct poly_file *p, char word[POLY_WORD]);
void poly_file_expect(struct poly_file *p, const char *word);
int poly_file_int(struct poly_file *p);
/* The number of entries of a list: no more than the file can contain with
 * `least` characters or more each, and such that four times it is an int. */
int poly_file_count(struct poly_file *p, int least);
double poly_file_real(struct poly_file *p);

/* Reports an error at the present line and sets `failed`. */
void poly_file_wrong(struct poly_file *p, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
