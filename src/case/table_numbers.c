/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/table_numbers.h"

static int numbers_of(const struct settings *s, const struct key *key,
                      double v[3])
{
    switch (key->type) {
    case KEY_REAL:
        v[0] = settings_real(s, key->path);
        return 1;
    case KEY_INT:
        v[0] = settings_int(s, key->path);
        return 1;
    case KEY_BOOL:
        v[0] = settings_bool(s, key->path);
        return 1;
    case KEY_VECTOR:
        settings_vector(s, key->path, v);
        return 3;
    default:
        return 0;
    }
}

int table_numbers(const struct settings *s, const struct key *keys,
                  double *numbers, int max)
{
    int n = 0;

    for (const struct key *key = keys; key->path != NULL; key++) {
        double v[3];
        const int given = numbers_of(s, key, v);

        for (int k = 0; k < given; k++, n++)
            if (n < max) numbers[n] = v[k];
    }
    return n;
}

int table_numbers_of_effect(const struct settings *s, const struct effect *e,
                            double numbers[EFFECT_NUMBERS])
{
    for (int k = 0; k < EFFECT_NUMBERS; k++)
        numbers[k] = 0.0;
    if (!settings_has(s, e->keys[0]->path)) return 0;
    table_numbers(s, e->keys[0], numbers, EFFECT_NUMBERS);
    return 1;
}
