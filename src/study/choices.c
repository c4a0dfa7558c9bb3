/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/plan.h"

#include "base/number.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The value that leaves a key as the case has it, there or not. */
static const char as_is[] = "as-is";

/* The length of the text up to the separator, or to its end, outside of
 * brackets and quotes; *open is set if one of these is not closed. */
static size_t length_to(const char *text, char separator, int *open)
{
    int depth = 0, quoted = 0;
    size_t n = 0;

    for (; text[n] != '\0'; n++) {
        if (text[n] == '"') quoted = !quoted;
        if (quoted && text[n] == '\\' && text[n + 1] != '\0') n++;
        if (quoted) continue;
        if (depth == 0 && text[n] == separator) break;
        depth += strchr("([{", text[n]) != NULL;
        depth -= strchr(")]}", text[n]) != NULL;
    }
    *open = depth != 0 || quoted;
    return n;
}

/* Adds the part without blanks around it. */
static void add_trimmed(struct texts *t, const char *text, size_t length)
{
    for (; length > 0 && strchr(" \t\n", text[0]) != NULL; length--)
        text++;
    while (length > 0 && strchr(" \t\n", text[length - 1]) != NULL)
        length--;
    texts_add(t, "%.*s", (int)length, text);
}

/* Adds the parts between separators. What is wrong, or NULL. */
static const char *choices_split(const char *text, char separator,
                                 struct texts *parts)
{
    const char *why = NULL;
    int open;

    for (;; text++) {
        const size_t length = length_to(text, separator, &open);
        add_trimmed(parts, text, length);
        if (parts->text[parts->n - 1][0] == '\0')
            why = "a value is missing: between entries stands a comma, between "
                  "values of keys that change together a colon";
        if (open) why = "a bracket or a quote without its other";
        text += length;
        if (*text == '\0') return why;
    }
}

/* Reads "key:key=entry,entry,..."; what is wrong with it, or NULL. */
static const char *read_choice(struct choice *c, const char *text)
{
    const char *const equal = strchr(text, '=');
    struct texts keys = {0}, entries = {0};

    if (equal == NULL || equal == text)
        return "expected path.to.key=value,value,...";
    add_trimmed(&keys, text, (size_t)(equal - text));
    const char *why = choices_split(keys.text[0], ':', &c->key);
    if (why == NULL) why = choices_split(equal + 1, ',', &entries);
    c->n = entries.n;
    for (int i = 0; i < c->n && why == NULL; i++) {
        why = choices_split(entries.text[i], c->key.n > 1 ? ':' : '\0',
                            &c->value);
        if (why == NULL && c->value.n != (i + 1) * c->key.n)
            why = "an entry has not as many values, with colons between, as "
                  "there are keys";
    }
    texts_free(&keys);
    texts_free(&entries);
    return why;
}

const char *choices_in_entry(const struct choice *c, int entry, int k)
{
    return c->value.text[entry * c->key.n + k];
}

/* The place of a text among others; -1 if it is not there. */
static int choices_place_of(const struct texts *t, const char *text)
{
    int k = t->n - 1;

    while (k >= 0 && strcmp(t->text[k], text) != 0)
        k--;
    return k;
}

/* 1 if two texts are the same, or the same number. */
static int choices_is_same(const char *a, const char *b)
{
    char *end_a, *end_b;
    const double x = strtod(a, &end_a), y = strtod(b, &end_b);

    return strcmp(a, b) == 0 || (end_a > a && end_b > b && *end_a == '\0' &&
                                 *end_b == '\0' && x == y);
}

static int is_entry_twice(const struct choice *c)
{
    for (int i = 0; i < c->n; i++)
        for (int j = 0; j < i; j++) {
            int same = 0;
            for (int k = 0; k < c->key.n; k++)
                same += choices_is_same(choices_in_entry(c, i, k),
                                        choices_in_entry(c, j, k));
            if (same == c->key.n) return 1;
        }
    return 0;
}

/* What is wrong with the keys of a choice beside those that are there, or NULL.
 */
static const char *choices_check_keys(const struct choices *c,
                                      const struct texts *keys)
{
    for (int k = 0; k < keys->n; k++) {
        if (choices_value(c, 0, keys->text[k]) != NULL)
            return "the key was given before";
        if (choices_place_of(keys, keys->text[k]) != k)
            return "a key is there twice";
    }
    return NULL;
}

/* A choice that is wrong is there as well, to be freed. */
int choices_add(struct choices *c, const char *text)
{
    struct choice one = {0};
    const char *why = read_choice(&one, text);

    if (why == NULL && is_entry_twice(&one)) why = "a value is there twice";
    if (why == NULL) why = choices_check_keys(c, &one.key);
    c->of = realloc(c->of, ((size_t)c->n + 1) * sizeof *c->of);
    if (c->of == NULL) exit(4);
    c->of[c->n++] = one;
    return why == NULL ? 0 : plan_wrong("%s: %s", text, why);
}

void choices_free(struct choices *c)
{
    for (int i = 0; i < c->n; i++) {
        texts_free(&c->of[i].key);
        texts_free(&c->of[i].value);
    }
    free(c->of);
    *c = (struct choices){0};
}

int choices_variants(const struct choices *c)
{
    double n = 1.0;

    for (int i = 0; i < c->n; i++)
        n *= c->of[i].n;
    return number_clamped(n, 0, INT_MAX);
}

/* How far apart two variants are that differ by one entry of the choice. */
static int stride(const struct choices *c, int i)
{
    int n = 1;

    for (int j = i + 1; j < c->n; j++)
        n *= c->of[j].n;
    return n;
}

int choices_entry(const struct choices *c, int variant, int i)
{
    return variant / stride(c, i) % c->of[i].n;
}

int choices_with(const struct choices *c, int variant, int i, int entry)
{
    return variant + (entry - choices_entry(c, variant, i)) * stride(c, i);
}

void choices_overrides(const struct choices *c, int variant, struct texts *set)
{
    for (int i = 0; i < c->n; i++) {
        const struct choice *const of = &c->of[i];
        const int entry = of->n == 1 ? 0 : choices_entry(c, variant, i);

        for (int k = 0; k < of->key.n && (variant >= 0 || of->n == 1); k++) {
            const char *const value = choices_in_entry(of, entry, k);
            if (strcmp(of->key.text[k], PLAN_THREADS) != 0 &&
                strcmp(value, as_is) != 0)
                texts_add(set, "%s=%s", of->key.text[k], value);
        }
    }
}

const char *choices_value(const struct choices *c, int variant, const char *key)
{
    for (int i = 0; i < c->n; i++) {
        const int k = choices_place_of(&c->of[i].key, key);
        if (k >= 0)
            return choices_in_entry(&c->of[i], choices_entry(c, variant, i), k);
    }
    return NULL;
}

static const char *last_part(const char *key)
{
    const char *const dot = strrchr(key, '.');

    return dot != NULL ? dot + 1 : key;
}

/* The last part of a key, where no other key of the study has the same; else
 * all. */
static const char *short_key(const struct choices *c, const char *key)
{
    for (int i = 0; i < c->n; i++)
        for (int k = 0; k < c->of[i].key.n; k++) {
            const char *const other = c->of[i].key.text[k];
            if (other != key && strcmp(last_part(other), last_part(key)) == 0)
                return key;
        }
    return last_part(key);
}

/* The values of a variant, with their keys or in words; but for one choice. */
static char *entries_of(const struct choices *c, int variant, int but,
                        int with_keys)
{
    char *text = NULL;
    size_t length;
    FILE *const out = open_memstream(&text, &length);
    const char *between = "";

    for (int i = 0; i < c->n; i++) {
        const struct choice *const of = &c->of[i];
        const int entry = choices_entry(c, variant, i);

        for (int k = 0; k < of->key.n && of->n > 1 && i != but; k++) {
            const char *const value = choices_in_entry(of, entry, k);
            fputs(between, out);
            if (with_keys)
                fprintf(out, "%s=%s", short_key(c, of->key.text[k]), value);
            else
                fputs(strcmp(value, as_is) == 0 ? "as it stands" : value, out);
            between = ", ";
        }
    }
    fclose(out);
    return text;
}

char *choices_label(const struct choices *c, int variant, int but)
{
    return entries_of(c, variant, but, 1);
}

char *words_variant(const struct choices *c, int variant, int but)
{
    return entries_of(c, variant, but, 0);
}

/* The components of a value: a number or [number, ...]. 0 for a word. */
static int numbers(const char *text, double v[3])
{
    int n = 0;
    char *end;

    if (text[0] == '[') text++;
    for (; n < 3; text = end + strspn(end, ", ")) {
        v[n] = strtod(text, &end);
        if (end == text) break;
        n++;
    }
    return text[0] == '\0' || text[0] == ']' ? n : 0;
}

/* The number of an entry as it stands; nan for a word. */
static double choices_number(const struct choice *c, int entry)
{
    double v[3], first[3], last[3], product = 1.0;
    const int n = numbers(choices_in_entry(c, entry, 0), v);
    int changing = 0;

    if (n == 0 || numbers(choices_in_entry(c, 0, 0), first) != n ||
        numbers(choices_in_entry(c, c->n - 1, 0), last) != n)
        return NAN;
    for (int k = 0; k < n; k++)
        if (first[k] != last[k]) {
            product *= v[k];
            changing++;
        }
    return changing > 0 && product > 0.0 ? pow(product, 1.0 / changing) : NAN;
}

double choices_size(const struct choice *c, int entry)
{
    int rises = 1, falls = 1, n = 0;
    double last = NAN;

    for (int i = 0; i < c->n; i++) {
        const double size = choices_number(c, i);
        if (isnan(size)) continue;
        rises &= n == 0 || size > last;
        falls &= n++ == 0 || size < last;
        last = size;
    }
    if (n < 2 || rises == falls) return NAN;
    return falls ? choices_number(c, entry) : 1.0 / choices_number(c, entry);
}

static int ends_with(const char *text, const char *end)
{
    const size_t n = strlen(text), m = strlen(end);
    return n >= m && strcmp(text + n - m, end) == 0;
}

void choices_tell_reversed(const struct choices *c)
{
    for (int i = 0; i < c->n; i++) {
        const struct choice *const of = &c->of[i];
        const char *const key = of->key.text[0];
        const double first = choices_number(of, 0),
                     last = choices_number(of, of->n - 1);

        if ((ends_with(key, ".cells") && last < first) ||
            (ends_with(key, ".step") && last > first))
            fprintf(stderr,
                    "%s goes from fine to coarse; its last value, %s, counts "
                    "as the finest\n",
                    key, choices_in_entry(of, of->n - 1, 0));
    }
}

int choices_axis(const struct choices *c)
{
    int axis = -1;

    for (int i = 0; i < c->n; i++)
        if (isfinite(choices_size(&c->of[i], 0)) &&
            (axis < 0 || c->of[i].n > c->of[axis].n))
            axis = i;
    return axis;
}
