/* case_check.h -- the hooks by which folders check a case.
 *
 * A case is read key by key by the files of src/case (schema_check.h). Whether
 * the values together are possible is checked by the folders checks/ and text/:
 * without them only the single values are. A descriptor is named in the
 * models.txt of its folder, and each function may be NULL. It returns 0, or the
 * exit code after one message.
 */
#ifndef CASE_CASE_CHECK_H
#define CASE_CASE_CHECK_H

#include "base/model.h"
#include "case/settings.h"

struct case_check {
    /* The case file, before it is read; what it includes lies in `folder`, or,
     * if that is NULL, where the program runs. */
    int (*file)(const char *file, const char *folder);
    /* The value of an override: what is wrong with it, or NULL. */
    const char *(*text)(const char *value);
    /* The value of a key, which has its type. */
    int (*value)(const struct key *key, const char *path,
                 const struct config_setting_t *value);
    /* What the case says of its mesh, before that is made. */
    int (*mesh)(const struct settings *s);
    /* The case as a whole. */
    int (*whole)(const struct settings *s);
    /* Whether a run can begin. */
    int (*run)(const struct settings *s);
};

/* All of them, ended by NULL. */
extern const struct case_check *const case_checks[];

#endif
