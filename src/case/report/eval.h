/* eval.h -- `winnow eval`: one equation at a time. */
#ifndef CASE_REPORT_EVAL_H
#define CASE_REPORT_EVAL_H

/* Lists every equation on stdout. */
void eval_list(void);

/* Prints the value of the equation for inputs "name=value". 0, or 2 after one
 * message. */
int eval_print(const char *key, int n, const char *const *inputs);

#endif
