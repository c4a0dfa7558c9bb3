/* xml.h -- text inside XML: & < > " are written as entities. */
#ifndef OUTPUT_XML_H
#define OUTPUT_XML_H

#include <stdio.h>

/* Writes text with the escapes that an attribute needs. */
void xml_put(FILE *out, const char *text);

#endif
