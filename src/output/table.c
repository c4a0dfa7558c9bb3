/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/table.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "base/text.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct table {
    char *path;
    int file; /* descriptor: each row is one write */
    int n_columns;
    off_t length; /* [bytes] of head and whole rows */
    char *row;    /* buffer for the text of one row */
};

void table_head_add(struct table_head *h, const char *format, ...)
{
    char text[512];
    va_list given;

    va_start(given, format);
    vsnprintf(text, sizeof text, format, given);
    va_end(given);
    h->name = alloc_grown(h->name, h->n, h->n + 1, sizeof *h->name);
    h->name[h->n++] = strcpy(alloc_zeroed(strlen(text) + 1, 1), text);
}

void table_head_clear(struct table_head *h)
{
    for (int i = 0; i < h->n; i++)
        free(h->name[i]);
    free(h->name);
    *h = (struct table_head){0};
}

static void table_put_head(FILE *out, int n, const char *const *names)
{
    for (int i = 0; i < n; i++) {
        text_put(out, names[i], TEXT_CSV);
        fputc(i < n - 1 ? ',' : '\n', out);
    }
}

static size_t row_size(int n)
{
    return (size_t)n * NUMBER_LENGTH + 1;
}

/* Writes the text of one row, with its newline; returns its length. */
static size_t row_text(int n, const double *row, char *text)
{
    char number[NUMBER_LENGTH];
    size_t length = 0;

    for (int i = 0; i < n; i++) {
        const size_t digits = strlen(number_text(row[i], number));
        memcpy(text + length, number, digits);
        length += digits;
        text[length++] = i < n - 1 ? ',' : '\n';
    }
    return length;
}

int table_write(const char *path, int n_columns, const char *const *names,
                int n_rows, const double *values)
{
    struct file *const f = file_create(path);

    if (f == NULL) return 1;
    char *const text = alloc_zeroed(row_size(n_columns), 1);
    table_put_head(file_stream(f), n_columns, names);
    for (int i = 0; i < n_rows; i++) {
        const double *const row = values + (size_t)i * (size_t)n_columns;
        fwrite(text, 1, row_text(n_columns, row, text), file_stream(f));
    }
    free(text);
    return file_commit(f);
}

/* The table in an open file, positioned after its last row. */
static struct table *table_opened(const char *path, int n_columns)
{
    const int file = open(path, O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC);

    if (file < 0) {
        file_report_failure("write", path, errno);
        return NULL;
    }
    struct table *const t = owner_create(sizeof *t);
    t->path = strcpy(alloc_zeroed(strlen(path) + 1, 1), path);
    t->file = file;
    t->n_columns = n_columns;
    t->length = lseek(file, 0, SEEK_END);
    t->row = owner_zeroed(t, row_size(n_columns), 1);
    return t;
}

struct table *table_create(const char *path, int n_columns,
                           const char *const *names)
{
    if (table_write(path, n_columns, names, 0, NULL) != 0) return NULL;
    return table_opened(path, n_columns);
}

/* The expected head line, as a new string. */
static char *head_text(int n, const char *const *names)
{
    char *text = NULL;
    size_t length = 0;
    FILE *const out = open_memstream(&text, &length);

    if (out == NULL) return strcpy(alloc_zeroed(1, 1), "");
    table_put_head(out, n, names);
    fclose(out);
    return text;
}

/* Non-zero if the file cannot be read or begins with other columns. */
static int head_wrong(const char *path, const char *head)
{
    FILE *const in = fopen(path, "r");
    char *line = NULL;
    size_t size = 0;

    if (in == NULL) return file_report_failure("read", path, errno);
    const int differs =
        getline(&line, &size, in) < 0 || strcmp(line, head) != 0;
    if (differs)
        fprintf(stderr, "winnow: %s has other columns than this run\n", path);
    free(line);
    fclose(in);
    return differs;
}

struct table *table_open(const char *path, int n_columns,
                         const char *const *names)
{
    char *const head = head_text(n_columns, names);
    const int wrong = head_wrong(path, head);

    free(head);
    return wrong ? NULL : table_opened(path, n_columns);
}

void table_state(struct table *t, struct state *s)
{
    long length = (long)t->length;

    if (!s->loading && fsync(t->file) != 0)
        s->failed = file_report_failure("write", t->path, errno);
    state_long(s, "bytes", "-", &length);
    if (!s->loading || s->failed) return;
    if (length > (long)t->length) {
        fprintf(stderr,
                "winnow: %s has only %ld of its %ld bytes when the state was "
                "saved\n",
                t->path, (long)t->length, length);
        s->failed = 1;
    } else if (ftruncate(t->file, (off_t)length) != 0)
        s->failed = file_report_failure("cut", t->path, errno);
    t->length = (off_t)length;
}

void table_free(struct table *t)
{
    if (t == NULL) return;
    close(t->file);
    free(t->path);
    owner_free(t);
}

int table_add(struct table *t, const double *row)
{
    const size_t length = row_text(t->n_columns, row, t->row);

    errno = 0;
    const ssize_t written = write(t->file, t->row, length);
    if (written == (ssize_t)length) {
        t->length += written;
        return 0;
    }
    if (errno == 0)
        errno = ENOSPC; /* a part was written before the disk was full */
    file_report_failure("write", t->path, errno);
    if (written > 0 && ftruncate(t->file, t->length) != 0)
        file_report_failure("remove half a row from", t->path, errno);
    return 1;
}
