/* texts.h -- a growing list of texts. */
#ifndef STUDY_TEXTS_H
#define STUDY_TEXTS_H

struct texts {
    int n;
    char **text; /* ended by NULL, once there is one */
};

/* Adds a text as printf makes it, and returns it; the list owns it. */
const char *texts_add(struct texts *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void texts_free(struct texts *t);

#endif
