/* facts.h -- a test program is a list of facts, run by Check.
 *
 *   FACTS("drag")
 *   {
 *       FACT(ls_5_2_force_with_24_over_re_is_stokes);
 *       FACT_FOR_EACH(momentum_is_kept, N_METHODS);
 *   }
 *
 * Each fact is a START_TEST ... END_TEST of the same file; its name is printed
 * as what has been shown (tests/run.sh). FACT_FOR_EACH runs it with _i from 0
 * to the number less one. Other calls of Check, such as a time limit, go to
 * `facts`.
 */
#ifndef TESTS_FACTS_H
#define TESTS_FACTS_H

#include <check.h>

#define FACTS(name)                                                            \
    static void add_facts(TCase *facts);                                       \
    int main(void)                                                             \
    {                                                                          \
        return facts_run(name, add_facts);                                     \
    }                                                                          \
    static void add_facts(TCase *facts)
#define FACT(test) tcase_add_test(facts, test)
#define FACT_FOR_EACH(test, count) tcase_add_loop_test(facts, test, 0, count)

/* 0 if all facts hold. */
static inline int facts_run(const char *name, void (*add)(TCase *))
{
    Suite *const suite = suite_create(name);
    TCase *const facts = tcase_create(name);

    suite_add_tcase(suite, facts);
    add(facts);
    SRunner *const runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    const int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}

#endif
