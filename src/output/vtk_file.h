/* vtk_file.h -- the frame of a VTK XML file: text first, then the data.
 *
 * The XML says of each array only where its bytes begin, counted from behind
 * the "_" of <AppendedData>. These offsets are not known when the XML is
 * written, so digits are reserved for them and filled in at the end.
 */
#ifndef OUTPUT_VTK_FILE_H
#define OUTPUT_VTK_FILE_H

#include "output/vtk_array.h"

#include <stdio.h>

/* Most arrays in one file, coordinates and cells among them. */
enum { VTK_FILE_ARRAYS = 64 };

/* One writer serves all files of a run, one after the other. */
struct vtk_file;

struct vtk_file *vtk_file_create(void);
void vtk_file_free(struct vtk_file *f);

/* Opens the file and writes its head up to the time; kind is the VTK type, such
 * as "RectilinearGrid"; extent is an attribute of it, or "". Non-zero after a
 * message. */
int vtk_file_begin(struct vtk_file *f, const char *path, const char *kind,
                   const char *extent, double time /* [s] */);

/* The stream, for text that is specific to one kind of file. */
FILE *vtk_file_stream(struct vtk_file *f);

/* Declares arrays in a section <name>, for n points or cells. The arrays must
 * exist until vtk_file_end. */
void vtk_file_section(struct vtk_file *f, const char *name, int n, int n_arrays,
                      const struct vtk_array *arrays);

/* Declares one array. */
void vtk_file_array(struct vtk_file *f, const struct vtk_array *a, int n);

/* Writes the arrays' bytes and commits the file; non-zero after a message. */
int vtk_file_end(struct vtk_file *f);

#endif
