/* key.h -- one row of documentation for one key of a case file.
 *
 * The rows are the only place where a key is described: the strict check and
 * its messages, `winnow list` and the reference chapter are all made from them.
 * No other file describes a key; the rows of an effect are in its descriptor.
 */
#ifndef BASE_KEY_H
#define BASE_KEY_H

#include <stddef.h>
#include <string.h>

enum key_type {
    KEY_GROUP,  /* { name = value; ... } */
    KEY_LIST,   /* ( { ... }, { ... } ), any number of groups */
    KEY_REAL,   /* a number */
    KEY_INT,    /* a whole number */
    KEY_BOOL,   /* true or false */
    KEY_NAME,   /* one of the words in allowed */
    KEY_TEXT,   /* any text */
    KEY_FILE,   /* the name of a file or folder */
    KEY_VECTOR, /* three numbers [x, y, z] */
    KEY_COUNTS, /* three whole numbers */
    KEY_FLAGS,  /* three of true or false */
    KEY_SERIES, /* a number, or ((time, number), ...) with time rising */
    KEY_CURVE,  /* ((x, number), ...) with x rising */
    KEY_PATCH   /* one of the words in allowed, or a group with one key */
};

/* The fallback of a key that may be left out, and then has no value; and that
 * of a key that must be given where a chosen model has the row in its tables.
 */
#define KEY_OPTIONAL ""
#define KEY_MODEL_REQUIRED "?"
/* A default: the first of the models that the key chooses between. */
#define KEY_FIRST "<first>"

enum { KEY_TABLES = 4 }; /* room in a descriptor: three tables and a NULL */

/* A table of keys is an array of rows, ended by KEY_END. */
#define KEY_END                                                                \
    {                                                                          \
        NULL, KEY_GROUP, NULL, NULL, NULL, NULL, NULL, NULL                    \
    }
struct model;

/* What else is known of a key, and of all keys of its group. */
enum key_mark {
    KEY_MAY_CHANGE = 1, /* a run may be resumed with another value */
    KEY_AFTER_BED = 2,  /* it comes after the bed, which settles without it */
    KEY_FOLDER = 4,     /* the file is the folder of a mesh */
    KEY_MADE_BY_RUN = 8 /* a run makes the file where it is not there */
};

#define KEY_DIVIDED ""
#define KEY_DIVIDED_ALL "*"

struct key {
    const char *path; /* "fluid.density"; <patch> stands for any side of
                         the box; keys of a list's groups follow its name */
    enum key_type type;
    const char *unit;    /* "kg/m^3"; "-" for a pure number, "" for words */
    const char *allowed; /* conditions and words, "> 0, <= 1" or "a | b" or
                            "auto | >= 1"; "" for no condition, and where the
                            words are the names of a kind of models */
    const char
        *fallback;      /* default as a case would write it; KEY_OPTIONAL;
                           KEY_MODEL_REQUIRED; NULL where the key is required */
    const char *what;   /* what it means, in one phrase */
    const char *source; /* equation or table it stands in, "" if none */
    const char *needs;  /* groups that must be there too, "fluid particles";
                           "" if none */

    /* Where its value goes (KEY_AT), and an int that is 1 where the case itself
     * names it; 0: nowhere. */
    size_t at, given;
    char member; /* what is there: d, i a number, v, n several (or an array), t
                    a text, s a series, o another thing */
    /* Of KEY_NAME: the member is a pointer to one of these descriptors (the
     * first member of each is its name), or the value of one of these choices.
     * Both end with NULL. */
    const void *models;
    const struct model *const *choices;
    size_t size; /* of KEY_LIST: of the struct of one of its groups; the member
                    is a struct key_list, and the rows of the groups have their
                    places in that struct */
    unsigned mark;       /* of enum key_mark */
    const char *divided; /* KEY_DIVIDED: several machines can share it, as they
                            can KEY_DIVIDED_ALL with all keys in its group; else
                            why they cannot; NULL: as its group */
};

/* In a row: the member that has its value, and the int of `given`. An enum is
 * an unsigned int. */
#define KEY_AT(type, name)                                                     \
    .at = offsetof(struct type, name) + 1,                                     \
    .member = _Generic(((struct type *)0)->name,                               \
                  double: 'd',                                                 \
                  double *: 'v',                                               \
                  int: 'i',                                                    \
                  unsigned: 'i',                                               \
                  int *: 'n',                                                  \
                  const char *: 't',                                           \
                  struct key_series: 's',                                      \
                  default: 'o')
#define KEY_GIVEN(type, name) .given = offsetof(struct type, name) + 1

/* The groups of a list: `item` is an array of n structs. */
struct key_list {
    int n;
    void *item;
};

/* The points of a KEY_SERIES or a KEY_CURVE, in one piece of memory; a constant
 * is one at 0. */
struct key_series {
    int n;
    double *at, *value;
};

/* This stands in the path of a row for the name of any side or patch.
 * key_matches: 1 if the row is that of the path. */
#define KEY_ANY_PATCH "<patch>"
static inline int key_matches(const char *row, const char *path)
{
    const char *const at = strstr(row, KEY_ANY_PATCH);
    const size_t before = at != NULL ? (size_t)(at - row) : 0;

    if (at == NULL) return strcmp(row, path) == 0;
    return strncmp(row, path, before) == 0 &&
           strcmp(at + strlen(KEY_ANY_PATCH),
                  path + before + strcspn(path + before, ".")) == 0;
}

#endif
