/* SPDX-License-Identifier: GPL-3.0-or-later */
/* symmetric_stages.c -- the stages of a level in one pass.
 *
 * A stage reads what the one before it wrote for the rows up to `pad` before
 * and after its own. So it can follow that far behind, while all that both read
 * is still in the second-level cache, and a pass reads the matrix once for all
 * stages. The rows near the ends of the chunk of a thread, which the next
 * thread reads, are computed first. The numbers are those of stage by stage.
 */
#include "linear/multigrid/level_matrix.h"

#include <omp.h>
#include <stddef.h>

enum {
    STRIDE = 512,              /* [-] rows that a stage takes at once */
    MIN_ROWS = 4096,           /* [-] fewer: stage by stage */
    MIN_PARALLEL_ROWS = 16384, /* [-] fewer: one thread */
};

/* How many chunks the rows are divided into; 0 if stage by stage is as good. A
 * chunk is longer than all that is computed first. */
static int chunks_of(const struct symmetric *S)
{
    const int fit = S->pad > 0 ? S->n / (4 * S->pad + STRIDE) : 0;
    const int threads = S->n < MIN_PARALLEL_ROWS ? 1 : omp_get_max_threads();

    if (S->n < MIN_ROWS || S->rest != NULL || S->n_bands > 3) return 0;
    return fit < threads ? 0 : threads;
}

static int chunk_first(const struct symmetric *S, int chunks, int c)
{
    return (int)((long long)S->n * c / chunks);
}

/* The two stages from zero; the first, x = weight D^-1 b, is computed where it
 * is needed. */
static inline void from_zero(const struct symmetric *S, int bands, int first,
                             int last, const float *b, struct level_smoothing w,
                             float *restrict y)
{
    const float *const inverse = S->inverse;

    for (int i = first; i < last; i++) {
        const float x = w.first * inverse[i] * b[i];
        float sum = S->diag[i] * x;

        for (int k = 0; k < bands; k++) {
            const int up = i + S->distance[k], down = i - S->distance[k];

            sum += S->band[k][i] * (w.first * inverse[up] * b[up]) +
                   S->band[k][down] * (w.first * inverse[down] * b[down]);
        }
        y[i] = (1.0F + w.previous) * x + 0.0F * x +
               w.second * inverse[i] * (b[i] - sum);
    }
}

static void from_zero_rows(int first, int last, const struct symmetric *S,
                           const float *b, struct level_smoothing w, float *y)
{
    switch (S->n_bands) {
    case 1:
        from_zero(S, 1, first, last, b, w, y);
        break;
    case 2:
        from_zero(S, 2, first, last, b, w, y);
        break;
    default:
        from_zero(S, 3, first, last, b, w, y);
    }
}

static void descend_chunk(const struct symmetric *S, int first, int last,
                          const float *b, struct level_smoothing w, float *y,
                          float *r)
{
    int smoothed = first + S->pad;

    while (first < last) {
        const int next = symmetric_lesser(smoothed + STRIDE, last - S->pad);
        const int known = next == last - S->pad ? last : next - S->pad;

        from_zero_rows(smoothed, next, S, b, w, y);
        symmetric_residual_rows(first, known, S, b, y, r);
        smoothed = next;
        first = known;
    }
}

int symmetric_descend(const struct symmetric *S, const float *b,
                      struct level_smoothing w, float *y, float *r)
{
    const int chunks = chunks_of(S);

#pragma omp parallel for schedule(static) if (chunks > 1)
    for (int c = 0; c < chunks; c++) {
        const int first = chunk_first(S, chunks, c);
        const int last = chunk_first(S, chunks, c + 1);

        from_zero_rows(first, first + S->pad, S, b, w, y);
        from_zero_rows(last - S->pad, last, S, b, w, y);
    }
#pragma omp parallel for schedule(static) if (chunks > 1)
    for (int c = 0; c < chunks; c++)
        descend_chunk(S, chunk_first(S, chunks, c),
                      chunk_first(S, chunks, c + 1), b, w, y, r);
    return chunks > 0;
}

/* What the way up reads and writes. */
struct ascent {
    const struct symmetric *S;
    const float *b;
    struct level_smoothing w;
    const int *parent;
    const float *coarse;
    float *x, *y;
};

static void add_coarse(const struct ascent *a, int first, int last)
{
    for (int i = first; i < last; i++)
        a->y[i] += a->coarse[a->parent[i]];
}

static void first_stage(const struct ascent *a, int first, int last)
{
    symmetric_relax_rows(first, last, a->S, a->b, a->y, 1.0F, a->y, 0.0F,
                         a->w.first, a->x);
}

static void second_stage(const struct ascent *a, int first, int last)
{
    symmetric_relax_rows(first, last, a->S, a->b, a->x, 1.0F + a->w.previous,
                         a->y, -a->w.previous, a->w.second, a->y);
}

/* The second stage writes y, which the first stage must have read. */
static void ascend_chunk(const struct ascent *a, int first, int last)
{
    const int pad = a->S->pad;
    int added = first + 2 * pad, smoothed = first + pad;

    while (first < last) {
        const int next = symmetric_lesser(added + STRIDE, last - 2 * pad);
        const int ready = next == last - 2 * pad ? last - pad : next - pad;
        const int known = ready == last - pad ? last : ready - pad;

        add_coarse(a, added, next);
        first_stage(a, smoothed, ready);
        second_stage(a, first, known);
        added = next;
        smoothed = ready;
        first = known;
    }
}

int symmetric_ascend(const struct symmetric *S, const float *b,
                     struct level_smoothing w, const int *parent,
                     const float *coarse, float *x, float *y)
{
    const struct ascent a = {S, b, w, parent, coarse, x, y};
    const int chunks = chunks_of(S), pad = S->pad;

#pragma omp parallel for schedule(static) if (chunks > 1)
    for (int c = 0; c < chunks; c++) {
        const int first = chunk_first(S, chunks, c);
        const int last = chunk_first(S, chunks, c + 1);

        add_coarse(&a, first, first + 2 * pad);
        add_coarse(&a, last - 2 * pad, last);
    }
#pragma omp parallel for schedule(static) if (chunks > 1)
    for (int c = 0; c < chunks; c++) {
        const int first = chunk_first(S, chunks, c);
        const int last = chunk_first(S, chunks, c + 1);

        first_stage(&a, first, first + pad);
        first_stage(&a, last - pad, last);
    }
#pragma omp parallel for schedule(static) if (chunks > 1)
    for (int c = 0; c < chunks; c++)
        ascend_chunk(&a, chunk_first(S, chunks, c),
                     chunk_first(S, chunks, c + 1));
    return chunks > 0;
}
