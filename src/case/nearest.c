/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/nearest.h"

#include <ctype.h>
#include <string.h>

static int min(int a, int b)
{
    return a < b ? a : b;
}

/* Upper and lower case count as equal. */
static int nearest_is_same(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* Rows of the table of distances between beginnings of a and b: the one being
 * filled and the two before it, which swapped letters look back to. */
int nearest_edits(const char *a, const char *b)
{
    const int n = (int)strlen(a), m = (int)strlen(b);
    int row[3][NEAREST_TEXT] = {{0}};

    if (n >= NEAREST_TEXT || m >= NEAREST_TEXT) return NEAREST_TEXT;
    for (int j = 0; j <= m; j++)
        row[0][j] = j;
    for (int i = 1; i <= n; i++) {
        int *const now = row[i % 3];
        const int *const last = row[(i + 2) % 3];
        const int *const before = row[(i + 1) % 3];

        now[0] = i;
        for (int j = 1; j <= m; j++) {
            const int same = nearest_is_same(a[i - 1], b[j - 1]);
            now[j] = min(last[j - 1] + !same, 1 + min(last[j], now[j - 1]));
            if (i > 1 && j > 1 && nearest_is_same(a[i - 1], b[j - 2]) &&
                nearest_is_same(a[i - 2], b[j - 1]))
                now[j] = min(now[j], before[j - 2] + 1);
        }
    }
    return row[n % 3][m];
}

/* A third of the word may be wrong, and always one letter of two. */
static int limit(const char *word)
{
    const int n = (int)strlen(word);
    return n < 2 ? 0 : 1 + (n - 1) / 3;
}

void nearest_init(struct nearest *n, const char *wanted)
{
    n->wanted = wanted;
    n->edits = strlen(wanted) < NEAREST_TEXT ? limit(wanted) + 1 : 0;
    n->best[0] = '\0';
}

void nearest_offer(struct nearest *n, const char *known)
{
    const size_t length = strlen(n->wanted);
    const int begins = length > 2 && strncmp(n->wanted, known, length) == 0;
    const int edits = begins ? 1 : nearest_edits(n->wanted, known);

    if (edits < n->edits && strlen(known) < NEAREST_TEXT) {
        n->edits = edits;
        strcpy(n->best, known);
    }
}

const char *nearest_best(const struct nearest *n)
{
    return n->best[0] != '\0' ? n->best : NULL;
}
