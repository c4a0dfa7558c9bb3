/* xml.h -- text inside XML: & < > " are written as entities and read back. */
#ifndef OUTPUT_XML_H
#define OUTPUT_XML_H

#include <stdio.h>

/* Writes text with the escapes that an attribute needs. */
void xml_put(FILE *out, const char *text);

/* Finds attribute="..." in a line and copies its value, entities resolved, to
 * value, of the given size with the closing zero. Non-zero if it is missing or
 * too long. */
int xml_attribute(const char *line, const char *attribute, char *value,
                  size_t size);

#endif
