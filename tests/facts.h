/* facts.h -- a test program is its facts, run by Check.
 *
 *   FACT(ls_5_2_force_with_24_over_re_is_stokes)
 *   {
 *       ck_assert_double_eq(...);
 *   }
 *
 *   FACT_FOR_EACH(momentum_is_kept, N_METHODS)
 *   {
 *       ... methods[_i] ...
 *   }
 *
 * The name of each is printed as what has been shown (tests/run.sh).
 * FACT_FOR_EACH runs it with _i from 0 to the number less one. Each may take a
 * minute, and has one thread unless it asks for more. What else Check is told
 * stands behind FACTS, with the TCase `facts`. This header has the program's
 * main, or facts_run alone for a program that defines FACTS_OWN_MAIN.
 */
#ifndef TESTS_FACTS_H
#define TESTS_FACTS_H

#include <check.h>
#include <omp.h>
#include <stddef.h>

struct fact {
    TTest test;
    int count;
    struct fact *next;
};
static struct fact *facts_first; /* by their lines */
static void (*facts_begin)(TCase *facts);

static void facts_add(struct fact *f, int count)
{
    struct fact **at = &facts_first;

    while (*at != NULL && (*at)->test.line < f->test.line)
        at = &(*at)->next;
    f->count = count;
    f->next = *at;
    *at = f;
}

/* Each is in the list before main begins. */
#define FACT(name) FACT_FOR_EACH(name, 1)
#define FACT_FOR_EACH(name, count)                                             \
    static void name(int _i);                                                  \
    __attribute__((constructor)) static void name##_is_a_fact(void)            \
    {                                                                          \
        static struct fact f = {{#name, name, __FILE__, __LINE__}, 0, NULL};   \
        facts_add(&f, count);                                                  \
    }                                                                          \
    static void name(int _i CK_ATTRIBUTE_UNUSED)

#define FACTS                                                                  \
    static void facts_told(TCase *facts);                                      \
    __attribute__((constructor)) static void facts_are_told(void)              \
    {                                                                          \
        facts_begin = facts_told;                                              \
    }                                                                          \
    static void facts_told(TCase *facts CK_ATTRIBUTE_UNUSED)

/* 0 if all facts hold. */
static int facts_run(void)
{
    Suite *const suite = suite_create("facts");
    TCase *const facts = tcase_create("facts");

    suite_add_tcase(suite, facts);
    tcase_set_timeout(facts, 60);
    omp_set_num_threads(1);
    if (facts_begin != NULL) facts_begin(facts);
    for (const struct fact *f = facts_first; f != NULL; f = f->next)
        tcase_add_loop_test(facts, &f->test, 0, f->count);
    SRunner *const runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    const int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}

#ifndef FACTS_OWN_MAIN
int main(void)
{
    return facts_run();
}
#endif

#endif
