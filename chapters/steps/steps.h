/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the thirteen steps share: numbers that can be changed, the loop over
 * time, random numbers, and pictures. There is no physics in it. A step has
 *
 *     numbers    what can be changed, as in build/steps/01-bounce e=0.9
 *     start()    makes the state at the time 0
 *     step()     moves it on by dt
 *     report()   prints what came out
 *     draw()     draws it, into PROGRAM.svg and PROGRAM.vtk
 *
 * In the book's pages the same programs draw on a canvas: there the functions
 * that begin with pen_ belong to chapters/tools/live.js.
 */
#ifndef STEPS_H
#define STEPS_H
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __wasm__ /* what a page calls, and what it gives */
#define DOOR(name) __attribute__((export_name(#name)))
#define PAGE(name) __attribute__((import_module("page"), import_name(#name)))
#else
#define DOOR(name)
#endif

/* From low to high, in steps of grain; 0: any value, on a scale of logs. */
struct number {
    const char *name;
    double *value, low, high, grain;
    const char *meaning; /* with its unit */
};
extern const struct number numbers[]; /* up to an empty one */

DOOR(start) void start(void);
void step(void);
DOOR(report) void report(void);
DOOR(draw) void draw(void);

static const double pi = 3.14159265358979323846;
static double t, dt, end; /* [s] time; each step says what dt and end are */

/* At most so many steps, up to the end; whether there are more. */
DOOR(advance) int advance(long most);
int advance(long most)
{
    static long done;
    for (; most > 0 && done < lround(end / dt); most--) {
        step();
        t = (double)++done * dt;
    }
    return done < lround(end / dt);
}

/* Ends a computation that has broken down. */
static inline _Noreturn void stop(const char *format, ...)
{
    va_list words;
    va_start(words, format);
    vfprintf(stderr, format, words);
    va_end(words);
    exit(3);
}

/* Between 0 and 1, and the same on any machine: Lehmer's generator. */
static inline double random_number(void)
{
    static long long state = 20100;
    state = 48271 * state % 2147483647;
    return (double)state / 2147483647.0;
}

/* x^y for x > 0. pow() of one machine differs from that of another in the last
 * digit, after which two beds are different ones; sums and products do not. */
static inline double power(double x, double y)
{
    const double ln_2 = 0.69314718055994530942;
    int n;
    if (!(x > 0.0 && x < 1e300)) return x;
    const double a = frexp(x, &n), z = (a - 1.0) / (a + 1.0); /* x = a 2^n */
    double ln_x = n * ln_2, exp_r = 1.0, term = 2.0 * z;
    for (int k = 1; k < 37; k += 2, term *= z * z)
        ln_x += term / k;
    const double j = floor(y * ln_x / ln_2 + 0.5), r = y * ln_x - j * ln_2;
    term = 1.0;
    for (int k = 1; k < 16; k++)
        exp_r += term *= r / k;
    return ldexp(exp_r, (int)j);
}

enum colour { INK, BLUE, RED, PALE };

#ifdef __wasm__
PAGE(size) void pen_size(double width, double height);
PAGE(move) void pen_move(double x, double y);
PAGE(line) void pen_line(double x, double y);
PAGE(end) void pen_end(enum colour colour, double width, double opacity);
PAGE(disc) void pen_disc(double x, double y, double r, enum colour, double);
PAGE(text) void pen_text(double x, double y, const char *text);
#else
static FILE *svg, *vtk;
static const char *const colours[] = {"#000", "#1f5fa8", "#c8321e", "#bbb"};

static inline void pen_size(double width, double height)
{
    fprintf(svg,
            "<svg xmlns='http://www.w3.org/2000/svg' width='%.0f' "
            "viewBox='0 0 %.0f %.0f' font-family='sans-serif' font-size='12'>\n"
            "<rect width='%.0f' height='%.0f' fill='#fff'/>\n",
            1.5 * width, width, height, width, height);
}

static inline void pen_move(double x, double y)
{
    fprintf(svg, "<path d='M%.2f %.2f", x, y);
}

static inline void pen_line(double x, double y)
{
    fprintf(svg, " %.2f %.2f", x, y);
}

/* A line of this width; or filled, with a width of 0. */
static inline void pen_end(enum colour colour, double width, double opacity)
{
    fprintf(svg, "' fill='%s' stroke='%s' stroke-width='%g' opacity='%.2f'/>\n",
            width > 0.0 ? "none" : colours[colour],
            width > 0.0 ? colours[colour] : "none", width, opacity);
}

static inline void pen_disc(double x, double y, double r, enum colour colour,
                            double opacity)
{
    fprintf(svg,
            "<circle cx='%.2f' cy='%.2f' r='%.2f' fill='%s' "
            "fill-opacity='%.2f' stroke='%s' stroke-width='0.5'/>\n",
            x, y, r, colours[colour], opacity, colours[colour]);
}

static inline void pen_text(double x, double y, const char *text)
{
    fprintf(svg, "<text x='%.1f' y='%.1f'>%s</text>\n", x, y, text);
}
#endif

/* The picture is 400 points wide. Its window is of width by height [m], and the
 * plot stands below it, or beside one that is tall. */
static struct {
    double left, bottom, scale; /* the window: [points], [points/m] */
    double x, y, width, height; /* the plot: [points] */
} view;

static inline void window(double width, double height, const char *caption)
{
    const int tall = height > 1.5 * width;
    view.scale = tall ? fmin(330.0 / height, 190.0 / width)
                      : fmin(396.0 / width, 270.0 / height);
    const double w = view.scale * width, h = view.scale * height;
    view.left = tall ? 2.0 : 200.0 - 0.5 * w;
    view.bottom = 20.0 + h;
    view.x = tall ? w + 50.0 : 45.0;
    view.y = tall ? 40.0 : h + 45.0;
    view.width = 390.0 - view.x;
    view.height = tall ? h - 60.0 : 125.0;
    pen_size(400.0, tall ? h + 22.0 : h + 205.0);
    pen_text(2.0, 13.0, caption);
    pen_move(view.left, view.bottom - h);
    pen_line(view.left, view.bottom);
    pen_line(view.left + w, view.bottom);
    pen_line(view.left + w, view.bottom - h);
    pen_end(INK, 1.0, 1.0);
}

/* In the window, in metres. */
static inline void put_disc(double x, double y, double r, enum colour colour,
                            double opacity)
{
    pen_disc(view.left + view.scale * x, view.bottom - view.scale * y,
             view.scale * r, colour, fmin(opacity, 1.0));
}

/* From x, y to x + a, y + b, as wide there as is said, and pointed. */
static inline void put_stroke(double x, double y, double a, double b,
                              double width)
{
    const double s = view.scale, r = 0.5 * width / sqrt(a * a + b * b + 1e-30);
    const double X = view.left + s * x, Y = view.bottom - s * y;
    pen_move(X - s * r * b, Y - s * r * a);
    pen_line(X + s * r * b, Y + s * r * a);
    pen_line(X + s * a, Y - s * b);
    pen_end(BLUE, 0.0, 1.0);
}

static inline void put_square(double x, double y, double side, double opacity)
{
    const double X = view.left + view.scale * x, s = view.scale * side;
    const double Y = view.bottom - view.scale * y;
    pen_move(X, Y);
    pen_line(X + s, Y);
    pen_line(X + s, Y - s);
    pen_line(X, Y - s);
    pen_end(BLUE, 0.0, fmin(fmax(opacity, 0.0), 1.0));
}

/* The points of the plot. Once there are too many, every second one goes. */
static struct {
    double x[1024], y[1024];
    int n, calls, every;
} curve;

static inline void point(double x, double y)
{
    if (curve.every == 0) curve.every = 1;
    if (curve.calls++ % curve.every != 0) return;
    curve.x[curve.n] = x;
    curve.y[curve.n++] = y;
    if (curve.n < 1024) return;
    for (int a = 0; a < 512; a++) {
        curve.x[a] = curve.x[2 * a];
        curve.y[a] = curve.y[2 * a];
    }
    curve.n = 512;
    curve.every *= 2;
}

static inline void axis(int k, double low, double high)
{
    double tick = pow(10.0, floor(log10(high - low))) / 5.0;
    char text[32];
    for (int a = 0; (high - low) / tick > (k == 0 ? 5.0 : 4.0); a++)
        tick *= a % 3 == 1 ? 2.5 : 2.0;
    for (double at = tick * ceil(low / tick); at <= high; at += tick) {
        const double part = (at - low) / (high - low);
        const double X = view.x + (k == 0 ? part * view.width : 0.0);
        const double Y = view.y + (k == 0 ? 1.0 : 1.0 - part) * view.height;
        pen_move(X, Y);
        pen_line(k == 0 ? X : X + view.width, k == 0 ? Y - view.height : Y);
        pen_end(PALE, 0.5, 1.0);
        snprintf(text, sizeof text, "%.4g", fabs(at) < 0.1 * tick ? 0.0 : at);
        pen_text(k == 0 ? X - 10.0 : view.x - 6.5 * (double)strlen(text) - 4.0,
                 k == 0 ? Y + 14.0 : Y + 4.0, text);
    }
}

/* The curve, with a red line at y = right: what should come out. */
static inline void plot(const char *x_title, const char *y_title, double right)
{
    double low[2] = {0.0, fmin(0.0, right)}, high[2] = {1e-9, right};
    for (int a = 0; a < curve.n; a++) {
        high[0] = fmax(high[0], curve.x[a]);
        low[0] = fmin(low[0], curve.x[a]);
        high[1] = fmax(high[1], curve.y[a]);
        low[1] = fmin(low[1], curve.y[a]);
    }
    if (!(high[1] > low[1])) high[1] = low[1] + 1.0;
    if (!(high[0] - low[0] < 1e30 && high[1] - low[1] < 1e30)) return;
    const double X = view.width / (high[0] - low[0]);
    const double Y = view.height / (high[1] - low[1]);
    axis(0, low[0], high[0]);
    axis(1, low[1], high[1]);
    pen_text(view.x, view.y - 6.0, y_title);
    pen_text(view.x, view.y + view.height + 29.0, x_title);
    pen_move(view.x, view.y + (high[1] - right) * Y);
    pen_line(view.x + view.width, view.y + (high[1] - right) * Y);
    pen_end(RED, 1.0, isfinite(right) ? 1.0 : 0.0);
    pen_move(view.x + (curve.x[0] - low[0]) * X,
             view.y + (high[1] - curve.y[0]) * Y);
    for (int a = 1; a < curve.n; a++)
        pen_line(view.x + (curve.x[a] - low[0]) * X,
                 view.y + (high[1] - curve.y[a]) * Y);
    pen_end(BLUE, 1.5, 1.0);
}

#ifdef __wasm__
DOOR(numbers_at) const struct number *numbers_at(void);
const struct number *numbers_at(void)
{
    return numbers;
}
#define vtk_grains(...) (void)0
#define vtk_cells(...) (void)0
#else
/* For ParaView: centres and diameters. */
static inline void vtk_grains(int n, const double *x, const double *y,
                              const double *R)
{
    fprintf(vtk, "# vtk DataFile Version 3.0\ngrains\nASCII\n");
    fprintf(vtk, "DATASET POLYDATA\nPOINTS %d double\n", n);
    for (int i = 0; i < n; i++)
        fprintf(vtk, "%.17g %.17g 0\n", x[i], y[i]);
    fprintf(vtk, "POINT_DATA %d\nSCALARS d double\nLOOKUP_TABLE default\n", n);
    for (int i = 0; i < n; i++)
        fprintf(vtk, "%.17g\n", 2.0 * R[i]);
}

/* The same of nx by ny cells dx wide, w in a row with ghosts: a vector. */
static inline void vtk_cells(int nx, int ny, int w, double dx, const double *a,
                             const double *b)
{
    fprintf(vtk, "# vtk DataFile Version 3.0\ncells\nASCII\n");
    fprintf(vtk, "DATASET STRUCTURED_POINTS\nDIMENSIONS %d %d 1\n", nx + 1,
            ny + 1);
    fprintf(vtk, "ORIGIN 0 0 0\nSPACING %g %g 1\nCELL_DATA %d\n", dx, dx,
            nx * ny);
    fprintf(vtk, "VECTORS f double\n");
    for (int j = 1; j <= ny; j++)
        for (int c = w * j + 1; c <= w * j + nx; c++)
            fprintf(vtk, "%.9g %.9g 0\n", a[c], b[c]);
}

static inline FILE *create(const char *program, const char *ending)
{
    char name[1000];
    snprintf(name, sizeof name, "%s%s", program, ending);
    FILE *const file = fopen(name, "w");
    if (file != NULL) return file;
    perror(name);
    exit(4);
}

/* Sets a number by a word of the command line, NAME=VALUE. */
static inline void set(const char *word)
{
    const size_t n = strcspn(word, "=");
    char *rest = NULL;
    for (const struct number *a = numbers; a->name != NULL; a++) {
        if (strlen(a->name) != n || strncmp(a->name, word, n) != 0) continue;
        *a->value = word[n] == '=' ? strtod(word + n + 1, &rest) : NAN;
        if (rest != NULL && rest > word + n + 1 && *rest == '\0' &&
            *a->value >= a->low && *a->value <= a->high)
            return;
        fprintf(stderr, "%s: %s is a number from %g to %g, the %s\n", word,
                a->name, a->low, a->high, a->meaning);
        exit(2);
    }
    fprintf(stderr, "%s: what can be changed:\n", word);
    for (const struct number *a = numbers; a->name != NULL; a++)
        fprintf(stderr, "    %s=%g  %s, %g to %g\n", a->name, *a->value,
                a->meaning, a->low, a->high);
    exit(2);
}

int main(int argc, char **argv)
{
    for (int a = 1; a < argc; a++)
        set(argv[a]);
    start();
    while (advance(1000))
        ;
    report();
    svg = create(argv[0], ".svg");
    vtk = create(argv[0], ".vtk");
    draw();
    fprintf(svg, "</svg>\n");
    return fclose(svg) + fclose(vtk) == 0 ? 0 : 4;
}
#endif
#endif
