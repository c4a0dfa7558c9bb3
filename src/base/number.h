/* number.h -- numbers as text that reads back to the same bits.
 *
 * With a decimal point whatever language the machine speaks: VTK reads "0,5"
 * as 0.
 */
#ifndef NUMBER_H
#define NUMBER_H

/* Room for any double and its closing zero [bytes]. */
enum { NUMBER_LENGTH = 32 };

/* Writes x to text and returns text: "0.1", "-1e-300", "nan", "inf", "-inf".
 * The shortest of 15, 16 and 17 digits that reads back to the same bits. */
const char *number_text(double x, char text[NUMBER_LENGTH]);

/* The same with at most so many digits, 1 to 17. */
const char *number_rounded(double x, int digits, char text[NUMBER_LENGTH]);

#endif
