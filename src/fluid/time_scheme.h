/* time_scheme.h -- how the change of momentum in a step is taken.  Chapter 19.
 *
 *   d(eps u)/dt = (now (eps u)^(n+1) - old (eps u)^n + older (eps u)^(n-1)) /
 * dt
 *
 * The three weights add up to zero, now - old + older: what does not change has
 * no derivative. A scheme also says how far what lags by a step, the flux that
 * carries momentum, is continued to the new time: x + ahead (x - x_older).
 */
#ifndef TIME_SCHEME_H
#define TIME_SCHEME_H

struct time_weights {
    double now, old, older; /* [-] */
    double ahead;           /* [-] */
};

struct time_scheme {
    const char *name; /* as a case spells it */
    const char *cite;
    const char *what;
    const char *function;
    int steps; /* [-] of the past that it looks at: 1 or 2 */
    /* r: this step over the one before it; 0 where there is none. */
    struct time_weights (*weights)(double r /* [-] */);
};

/* All schemes, ended by a row without a name; NULL for an unknown name. */
extern const struct time_scheme time_schemes[];
const struct time_scheme *time_scheme_named(const char *name);

#endif
