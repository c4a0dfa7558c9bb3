/* override.h -- overrides and defaults of values.
 *
 * An override "path.to.key=value" replaces what the case says, a default adds
 * what it leaves out. Both are written as a case would write them.
 */
#ifndef CASE_OVERRIDE_H
#define CASE_OVERRIDE_H

#include <libconfig.h>

/* Applies an override; its text is borrowed for as long as the tree exists. A
 * value that is a bare word is a text. Missing groups of the path are created;
 * a group of a list is named by its number, counted from 0. 0, or 2 after a
 * message. */
int override_apply(config_t *tree, const char *text);

/* Adds a key that the group leaves out. */
void override_default(config_setting_t *group, const char *name,
                      const char *value);

#endif
