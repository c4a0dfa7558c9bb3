/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/recorder.h"

#include "facts.h"
#include "capture.h"

#include <string.h>

static char said[CAPTURE_TEXT];

/* A run of n steps in the style; `said` receives its output. */
static void run_steps(enum progress_style style, int n)
{
    struct capture c = capture_begin(2);
    struct progress p;

    progress_init(&p, 0.0, 1.0, 0);
    p.style = style;
    for (int i = 1; i <= n; i++)
        progress_show(&p, (double)i / n);
    progress_end(&p);
    capture_end(&c, said);
}

static int count(const char *text, char what)
{
    int n = 0;

    for (; *text != '\0'; text++)
        n += *text == what;
    return n;
}

/* A run of a day says after seconds how long it will take: 10 s, 20, 40, ... */
FACT(a_long_run_has_lines_before_its_first_tenth)
{
    struct capture c = capture_begin(2);
    struct progress p;

    progress_init(&p, 0.0, 1.0, 0);
    p.style = PROGRESS_LINES;
    for (int i = 0; i < 50; i++) {
        p.began -= 1.0;
        p.drawn -= 1.0;
        progress_show(&p, 1e-4 * (i + 1));
    }
    progress_end(&p);
    capture_end(&c, said);
    ck_assert_int_eq(count(said, '\n'), 3);
    ck_assert_ptr_nonnull(strstr(said, "  0 %  t = 0.001 of 1 s"));
}

FACT(away_from_a_terminal_there_are_ten_lines)
{
    run_steps(PROGRESS_LINES, 1000);
    ck_assert_int_eq(count(said, '\n'), 10);
    ck_assert_ptr_nonnull(strstr(said, " 10 %  t = 0.1 of 1 s"));
    ck_assert_ptr_nonnull(strstr(said, "100 %  t = 1 of 1 s, 0:00 left"));
}

FACT(few_steps_give_few_lines)
{
    run_steps(PROGRESS_LINES, 3);
    ck_assert_int_eq(count(said, '\n'), 3);
}

FACT(bar_stays_on_one_line_and_ends_full)
{
    run_steps(PROGRESS_BAR, 1000);
    ck_assert_int_eq(count(said, '\n'), 1);
    ck_assert_ptr_nonnull(
        strstr(said, "[##############################] 100 %"));
}

/* A bar for each of 1000 steps would cost more than the steps. */
FACT(bar_is_not_drawn_for_every_step)
{
    run_steps(PROGRESS_BAR, 1000);
    ck_assert_int_lt(count(said, '\r'), 10);
}

FACT(quiet_says_nothing)
{
    run_steps(PROGRESS_QUIET, 1000);
    ck_assert_str_eq(said, "");
}

FACT(quiet_and_files_are_told_from_terminals)
{
    struct capture c = capture_begin(2); /* a file, then */
    struct progress p;

    progress_init(&p, 0.0, 1.0, 1);
    ck_assert_int_eq(p.style, PROGRESS_QUIET);
    progress_init(&p, 0.0, 1.0, 0);
    ck_assert_int_eq(p.style, PROGRESS_LINES);
    capture_end(&c, said);
}

FACT(time_left_follows_from_time_spent)
{
    const struct progress p = {PROGRESS_BAR, 0.0, 2.0, 0.0, 0.0, 0};
    char text[PROGRESS_TEXT];

    progress_line(&p, 0.5, 25.0, text); /* a quarter in 25 s: 75 s are left */
    ck_assert_str_eq(text, "[#######.......................]  25 %  "
                           "t = 0.5 of 2 s, 1:15 left");
    progress_line(&p, 1e-3, 10.0, text); /* 2000 times 10 s, less 10 s */
    ck_assert_ptr_nonnull(strstr(text, "5:33:10 left"));
    progress_line(&p, 0.0, 10.0, text);
    ck_assert_ptr_nonnull(strstr(text, "?:?? left"));
}

/* A run that goes on from 1 s has spent nothing on the first second. */
FACT(progress_counts_from_where_the_run_begins)
{
    const struct progress p = {PROGRESS_BAR, 1.0, 2.0, 0.0, 0.0, 0};
    char text[PROGRESS_TEXT];

    progress_line(&p, 1.5, 30.0, text);
    ck_assert_ptr_nonnull(strstr(text, " 50 %"));
    ck_assert_ptr_nonnull(strstr(text, "0:30 left"));
}
