/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_file.h"

#include "mesh/mesh_form.h"
#include "case/mesh_reader.h"
#include "case/case_check.h"
#include "case/case_part.h"
#include "case/keys.h"
#include "case/models.h"
#include "case/recorder_part.h"

#include <assert.h>
#include <stddef.h>

void case_file_tables(const struct key *tables[CASE_FILE_TABLES])
{
    int n = 0;

    tables[n++] = keys_core;
    for (int i = 0; mesh_forms[i] != NULL; i++)
        tables[n++] = mesh_forms[i]->keys;
    for (int i = 0; case_parts[i] != NULL; i++)
        if (case_parts[i]->keys != NULL) tables[n++] = case_parts[i]->keys;
    for (int i = 0; recorder_parts[i] != NULL; i++)
        if (recorder_parts[i]->keys != NULL)
            tables[n++] = recorder_parts[i]->keys;
    n += models_tables(&tables[n], CASE_FILE_TABLES - 1 - n);
    assert(n < CASE_FILE_TABLES);
    tables[n] = NULL;
}

struct settings *case_file_read(const char *file, int n_overrides,
                                const char *const *overrides, int *code)
{
    const struct key *tables[CASE_FILE_TABLES];
    struct settings *s;

    case_file_tables(tables);
    s = settings_create(file, n_overrides, overrides, tables, code);
    if (s == NULL) return NULL;
    MODELS_UNTIL(*code, case_checks, mesh, s);
    if (*code == 0 && mesh_readers[0] != NULL) *code = mesh_readers[0]->read(s);
    MODELS_UNTIL(*code, case_checks, whole, s);
    if (*code == 0) return s;
    settings_free(s);
    return NULL;
}
