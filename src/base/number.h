/* number.h -- numbers as text that reads back to the same bits, and whole
 * numbers made of real ones.
 *
 * Texts have a decimal point in every locale: VTK reads "0,5" as 0. The cast of
 * a real number beyond the range of an int is undefined in C, and most machines
 * give -2147483648. So all conversions of real numbers are done here.
 */
#ifndef BASE_NUMBER_H
#define BASE_NUMBER_H

/* Length of the longest double with its closing zero [bytes]. */
enum { NUMBER_LENGTH = 32 };

/* Writes x to text and returns text: "0.1", "-1e-300", "nan", "inf", "-inf".
 * The shortest of 15, 16 and 17 digits that reads back to the same bits. */
const char *number_text(double x, char text[NUMBER_LENGTH]);

/* The same with at most this number of digits, 1 to 17. */
const char *number_rounded(double x, int digits, char text[NUMBER_LENGTH]);

/* The whole number that x is, once the caller has rounded it: 0. Non-zero, and
 * *n left alone, if it is beyond the range of *n or no number at all. The range
 * of number_long ends at 2^53, beyond which a double does not tell a number
 * from the next. */
int number_int(double x, int *n);
int number_long(double x, long *n);

/* 1 if x is a coordinate: at most 1e12 m, so that its powers are finite, too. A
 * length is at least 1e-12 m as well. */
static inline int number_is_coordinate(double x)
{
    return x >= -1e12 && x <= 1e12;
}

static inline int number_is_length(double x)
{
    return x >= 1e-12 && x <= 1e12;
}

/* x without its fraction, but clamped to min .. max; min if x is not a
 * number. For values that leave the range by rounding alone, and for values for
 * which the end of the range serves as well. */
static inline int number_clamped(double x, int min, int max)
{
    if (!(x > min)) return min;
    return x < max ? (int)x : max;
}

#endif
