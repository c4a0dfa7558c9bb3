/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "tell/check.h"

#include "facts.h"
#include "capture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* An input of eval at a time: "Re=50 eps_f=0.6" is cut at the blanks. */
static int evaluate(const char *key, const char *inputs, char *out, char *err)
{
    static char text[256];
    const char *list[EQUATIONS_INPUTS + 2];
    struct capture c_out, c_err;
    int n = 0, code;

    snprintf(text, sizeof text, "%s", inputs);
    for (char *w = strtok(text, " "); w != NULL; w = strtok(NULL, " "))
        list[n++] = w;
    c_out = capture_begin(1);
    c_err = capture_begin(2);
    code = eval_print(key, n, list);
    capture_end(&c_err, err);
    capture_end(&c_out, out);
    return code;
}

static char out[CAPTURE_TEXT], err[CAPTURE_TEXT];

/* The values were computed apart from this program, with the formulas of the
 * documents in double precision. Printed are 12 digits: 1e-11 is what the last
 * of them may differ by; a wrong exponent or sign is off by far more. */
static const struct {
    const char *key, *inputs, *symbol;
    double value;
    const char *unit;
} known[] = {
    {"XS11:2.10", "eps_s=0.4 rho_f=1.2 mu=1.8e-5 d=1.2e-3 u_r=0.9", "B",
     3.85792395579081e-06, "kg/s"},
    {"XS11:2.11", "eps_s=0.4 rho_f=1.2 mu=1.8e-5 d=1.2e-3 u_r=0.9", "beta",
     1023.34611272791, "kg/(m^3 s)"},
    {"XS11:2.12", "rho_f=1.2 mu=1.8e-5 d=1.2e-3 u_r=0.9", "Re", 72.0, "-"},
    {"XS11:2.13", "Re=50 eps_f=0.6", "V_r", 0.382618351595941, "-"},
    {"XS11:2.13", "Re=72 eps_f=0.9", "V_r", 0.740307783674227, "-"},
    {"XS11:3.6", "zeta=0.5", "K", 0.31640625, "-"},
    {"XS11:3.6", "zeta=1.5", "K", 0.0, "-"},
    {"XS11:3.17", "rho_s=2650 eps_s=0.2 rho_f=1000 mu=1e-3 d=1e-3 u_r=3",
     "tau_p", 0.00109013049583229, "s"},
    {"XS11:4.1", "rho_s=2650 eps_s=0.2 rho_f=1000 mu=1e-3 d=1e-3 u_f=3 t=1e-3",
     "u", 1.46614664196325, "m/s"},
    {"SX15:6", "r=2.4e-3 b=4.8e-3", "h", 1264671.86903772, "1/m^3"},
    {"SX15:14", "dt=1e-4 b_t=1e-2", "alpha", 0.990099009901, "-"},
    {"LS:4.4", "k=1e4 e=0.8 m_i=1e-3 m_j=2e-3", "eta", 0.365869376973942,
     "kg/s"},
    {"LS:4.7",
     "E_i=380e9 E_j=70e9 nu_i=0.23 nu_j=0.25 R_i=2.5e-3 R_j=5e-3 delta=1e-6",
     "F_n", 3.42664982478123, "N"},
    {"LS:4.9", "E_i=380e9 E_j=70e9 nu_i=0.23 nu_j=0.25 R_i=2.5e-3 R_j=5e-3",
     "k_n", 3426649824.78123, "N/m^1.5"},
    {"LS:4.10",
     "E_i=380e9 E_j=70e9 nu_i=0.23 nu_j=0.25 R_i=2.5e-3 R_j=5e-3 delta=1e-6",
     "k_t", 4415976.27048677, "N/m"},
    {"LS:4.11", "m=2e-3 k_n=800", "eta_n", 2.52982212813470, "kg/s"},
    {"LS:4.12", "m=2e-3 k_t=300", "eta_t", 1.54919333848297, "kg/s"},
    {"LS:4.13", "q_i=3e-12 q_j=-5e-12 eps_r=1.5 l=0.003", "F",
     -9.98616865806797e-09, "N"},
    {"LS:4.14", "A=5e-20 D_i=1e-3 D_j=2e-3 l=4e-10", "F", 1.73611111111111e-05,
     "N"},
    {"LS:4.15", "gamma=0.072 theta=0.5 R_i=1e-3 R_j=3e-3", "F",
     -0.000794017995653752, "N"},
    {"LS:5.2", "rho_f=1.2 C_D=0.44 d=1e-3 u_r=2", "F", 8.29380460547705e-07,
     "N"},
    {"LS:5.4", "rho_f=1000 mu=1e-3 d=1e-3 t=4 rate=0.5", "F",
     5.31736155271655e-06, "N"},
    {"LS:5.5", "d=1e-4 nu=1e-6 G=3", "Re_G", 0.03, "-"},
    {"LS:5.6", "mu=1e-3 d=1e-4 u_r=1e-3 Re_G=0.04", "F", 3.22e-11, "N"},
    {"LS:5.7", "rho_f=1.2 C_LR=0.3 d=0.04 u_r=20", "F", 0.090477868423386, "N"},
    {"LS:5.11", "r=6e-4 rho=1000 G=4.5e4 nu=0.33", "T_R", 0.000302005205419072,
     "s"},
    {"LS:5.12", "rho_p=3000 d=1e-4 mu=1e-4", "tau", 0.0166666666666667, "s"},
    {"LS:5.13", "rho_p=3000 d=1e-4 mu=1e-4 Re=1.37337", "tau",
     0.0140465482201807, "s"},
    {"LS:5.26", "alpha=0.9 Re=100", "C_d", 1.14695428899973, "-"},
    {"LS:5.27", "alpha=0.45 rho_f=1000 mu=1e-3 d=1e-3 u_r=0.01", "beta",
     110458.333333333, "kg/(m^3 s)"},
    {"LS:5.27", "alpha=0.9 rho_f=1.2 mu=1.8e-5 d=1e-3 u_r=1.5", "beta",
     184.238223650342, "kg/(m^3 s)"},
    {"EW18:6", "rho_f=1000 V=0.1 L=1e-3 mu=1e-3", "Re_in", 100.0, "-"},
    {"EW18:7", "g=9.81 L=1e-3 V=0.1", "Fr", 0.981, "-"},
    {"EW18:8", "rho_p=2500 rho_f=1000", "rho_r", 2.5, "-"},
    /* the gas of EW18 Table 1, which prints 118 */
    {"EW18:9", "rho_r=85 Re_in=25", "St", 118.055555555556, "-"},
    {"EW18:19", "r=1e-3 sigma_k=2e-3", "W", 7004117.13072521, "1/m^3"},
    {"EW18:20", "delta_05=1e-3", "sigma_k", 0.000424660900144010, "m"},
    {"EW18:22", "eps_mf=0.42 rho_f=1.2 rho_s=2650 mu=1.8e-5 d=1e-3 g=9.81",
     "u_mf", 0.6546464594818425, "m/s"},
    {"EW18:26", "F=2e-6 rho_f=1.2 d=1e-3 eps=0.6 u_r=1.1", "C_d",
     9.743185986648015, "-"},
    {"EW18:27", "eps=0.6 rho_f=1.2 mu=1.8e-5 d=1e-3 u_r=1.1", "Re_p", 44.0,
     "-"},
    {"EW18:33", "a=0.9 b=2 C=1.5 w=-0.7", "C_next", 0.7397541479043059, "-"},
    {"EW18:35", "a=0.9 n=10 C=1.5", "E", 0.5230176601500002, "-"},
    {"EW18:36", "a=0.9 b=2 n=10", "Var", 3.5136933816377227, "-"},
    {"EW18:37", "a=0.9 dt=0.003", "T", 0.028473664743089714, "s"},
    {"EW18:A.1", "eps=0.6 rho_f=1.2 mu=1.8e-5 d=1e-3 u_r=1.1", "Re_p", 44.0,
     "-"},
    {"EW18:A.2", "eps=0.6 rho_f=1.2 mu=1.8e-5 d=1e-3 u_r=1.1", "F",
     1.6109057565460718e-06, "N"},
    {"EW18:A.3", "Re=20", "chi", 3.0627399388131966, "-"},
    {"EW18:A.4", "Re=50", "C_d", 1.5380955536986358, "-"},
    {"EW18:A.5", "eps=0.6 rho_f=1.2 mu=1.8e-5 d=1e-3 u_r=1.1", "F",
     3.850849518733467e-06, "N"},
    {"EW18:A.6", "eps=0.6 Re=30", "g", 17.83890413310544, "-"},
    {"EW18:B.7", "h=1e-3 b=2.5e-3 x=3e-4 phi_1=0.2 phi_2=0.5 phi_3=0.9", "X",
     322.29938562496375, "1/m"},
    {"drag:syamlal-obrien", "eps_f=0.62 Re=37", "F", 16.0109637809333, "-"},
    {"drag:gidaspow", "eps_f=0.62 Re=37", "F", 17.5959648514279, "-"},
    {"drag:schiller-naumann", "eps_f=0.62 Re=37", "F", 5.62786175064033, "-"},
    {"drag:di-felice", "eps_f=0.62 Re=37", "F", 12.0089064358692, "-"},
    {"drag:di-felice-printed", "eps_f=0.62 Re=37", "F", 19.3692039288213, "-"},
    {"drag:beetstra", "eps_f=0.62 Re=37", "F", 17.4972424289779, "-"},
    {"drag:huilin-gidaspow", "eps_f=0.62 Re=37", "F", 17.5851243502401, "-"},
    {"drag:hill-koch-ladd", "eps_f=0.62 Re=37", "F", 14.5717882666598, "-"},
    {"drag:tenneti", "eps_f=0.62 Re=37", "F", 15.7721490043907, "-"},
    {"drag:rong", "eps_f=0.62 Re=37", "F", 13.6169545181118, "-"},
    {"drag:cello", "eps_f=0.62 Re=37", "F", 16.45211616736, "-"},
    {"drag:dallavalle", "eps_f=0.62 Re=37", "F", 6.28007191856053, "-"},
    {"drag:haider-levenspiel", "eps_f=0.62 Re=37", "F", 5.71378251957274, "-"},
};

FACT(every_equation_has_its_independent_value)
{
    const size_t n = sizeof known / sizeof known[0];

    for (size_t i = 0; i < n; i++) {
        char symbol[32], unit[32];
        double value;

        ck_assert_int_eq(evaluate(known[i].key, known[i].inputs, out, err), 0);
        ck_assert_int_eq(
            sscanf(out, "%31s = %lf [%31[^]]]", symbol, &value, unit), 3);
        ck_assert_str_eq(symbol, known[i].symbol);
        ck_assert_str_eq(unit, known[i].unit);
        ck_assert_msg(
            fabs(value - known[i].value) <= 1e-11 * fabs(known[i].value),
            "%s: %.15g, not %.15g", known[i].key, value, known[i].value);
    }
    struct equation e;
    for (int j = 0; equations_at(j, &e); j++) {
        int shown =
            e.value == NULL; /* a drag law: test_drag_published and others */
        for (size_t i = 0; i < n; i++)
            shown += strcmp(known[i].key, e.key) == 0;
        ck_assert_msg(shown > 0, "%s has no value here", e.key);
    }
}

FACT(value_is_one_line_with_symbol_and_unit)
{
    ck_assert_int_eq(evaluate("XS11:3.6", "zeta=0.5", out, err), 0);
    ck_assert_str_eq(out, "K = 0.31640625 [-]\n");
    ck_assert_str_eq(err, "");
}

FACT(order_of_the_inputs_does_not_matter)
{
    static char other[CAPTURE_TEXT];

    ck_assert_int_eq(evaluate("XS11:2.13", "Re=50 eps_f=0.6", out, err), 0);
    ck_assert_int_eq(evaluate("XS11:2.13", "eps_f=0.6 Re=50", other, err), 0);
    ck_assert_str_eq(out, other);
}

static void refused(const char *key, const char *inputs, const char *part)
{
    ck_assert_int_eq(evaluate(key, inputs, out, err), 2);
    ck_assert_str_eq(out, "");
    ck_assert_msg(strstr(err, part) != NULL, "no \"%s\" in %s", part, err);
}

FACT(wrong_inputs_are_refused_with_what_it_takes)
{
    refused("XS11:2.13", "Re=50", "eps_f is missing; it takes Re [-], eps_f");
    refused("XS11:2.13", "", "Re is missing");
    refused("XS11:2.13", "Re=50 eps_f=0.6 mu=1", "mu=1 is not one of");
    refused("XS11:2.13", "Re=50 eps_f=0.6 Re=5", "Re=5 is given twice");
    refused("XS11:2.13", "Re=50 eps_f=high", "eps_f=high is not a number");
    refused("XS11:2.13", "Re=50 eps_f=", "is not a number");
    refused("XS11:2.13", "Re=50 eps_f=nan", "is not a number");
    refused("XS11:2.13", "Re eps_f=1", "Re is not one of");
    refused("xs11:2.133", "", "did you mean XS11:2.13?");
    refused("elephant", "", "winnow eval lists all");
}

FACT(value_that_is_no_number_is_refused)
{
    refused("LS:5.26", "alpha=0 Re=1", "C_d has no value");
}

FACT(list_names_every_equation_with_units_and_function)
{
    struct capture c = capture_begin(1);

    eval_list();
    capture_end(&c, out);
    struct equation e;
    for (int j = 0; equations_at(j, &e); j++) {
        ck_assert_ptr_nonnull(strstr(out, e.key));
        ck_assert_ptr_nonnull(strstr(out, e.inputs));
        ck_assert_ptr_nonnull(strstr(out, e.function));
        ck_assert_int_le(equations_inputs(&e), EQUATIONS_INPUTS);
    }
}
