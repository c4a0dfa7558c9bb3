/* list.h -- `winnow list`: what there is to choose from. */
#ifndef TELL_LIST_H
#define TELL_LIST_H

/* Prints the kinds of models on stdout. */
void list_kinds(void);

struct model;

/* Prints a model with its keys. */
void list_model(const struct model *m);

/* Prints every model of a kind with its keys, or for "keys" the whole table of
 * keys. 0, or 2 after a message if there is no such kind. */
int list_models(const char *kind);

/* The keys of one part of a case ("fluid"), or of all for NULL. Returns the
 * exit code, 2 after a message if there is no such part. */
int list_keys(const char *part);

#endif
