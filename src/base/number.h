/* number.h -- numbers as text that reads back to the same bits, and whole
 * numbers made of real ones.
 *
 * Texts have a decimal point whatever language the machine speaks: VTK reads
 * "0,5" as 0. A real number beyond the range of an int has no int: C leaves
 * open what a cast makes of it, and most machines make -2147483648. So nothing
 * in this program casts a real number; it asks here.
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

/* The whole number that x is, once the caller has rounded it: 0. Non-zero, and
 * *n left alone, if it is beyond the range of *n or no number at all. The range
 * of number_long ends at 2^53, beyond which a double does not tell a number
 * from the next. */
int number_int(double x, int *n);
int number_long(double x, long *n);

/* x without its fraction, but no less than least and no more than most; least
 * if x is no number. For what is in that range but for rounding, and for what
 * is as good beyond the range as at its end. */
static inline int number_clamped(double x, int least, int most)
{
    if (!(x > least)) return least;
    return x < most ? (int)x : most;
}

#endif
