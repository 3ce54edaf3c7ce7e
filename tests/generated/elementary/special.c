/* Tests the special cases of the elementary functions, as C99's Annex F defines them: signed
 * zeros, infinities, arguments outside the domain. Prints one line for each case, `ok` or
 * `FAIL`. */
#include <frob/elementary.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

static bool failed;

static bool same(double a, double b)
{
    if (isnan(a) || isnan(b))
        return isnan(a) && isnan(b);
    return a == b && signbit(a) == signbit(b);
}

static void check(char const *what, double is, double should)
{
    bool const ok = same(is, should);
    printf("%s %s\n", ok ? "ok" : "FAIL", what);
    if (!ok) {
        printf("  is %a, should be %a\n", is, should);
        failed = true;
    }
}

#define IS(call, value) check(#call " = " #value, call, value)

static void exponentials(void)
{
    IS(frob_exp(0.0), 1.0);
    IS(frob_exp(-0.0), 1.0);
    IS(frob_exp(INFINITY), INFINITY);
    IS(frob_exp(-INFINITY), 0.0);
    IS(frob_exp(NAN), NAN);
    IS(frob_exp(709.782712893384), 0x1.fffffffffff2ap1023);
    IS(frob_exp(709.7827128933841), INFINITY);
    IS(frob_exp(-745.1332191019411), 0x1p-1074);
    IS(frob_exp(-745.1332191019412), 0.0);
    IS(frob_log(1.0), 0.0);
    IS(frob_log(0.0), -INFINITY);
    IS(frob_log(-0.0), -INFINITY);
    IS(frob_log(-1.0), NAN);
    IS(frob_log(INFINITY), INFINITY);
    IS(frob_log(-INFINITY), NAN);
    IS(frob_log(NAN), NAN);
    IS(frob_log(0x1p-1074), -0x1.74385446d71c3p9);
}

static void powers(void)
{
    IS(frob_pow(0.0, -3.0), INFINITY);
    IS(frob_pow(-0.0, -3.0), -INFINITY);
    IS(frob_pow(-0.0, -2.0), INFINITY);
    IS(frob_pow(-0.0, -INFINITY), INFINITY);
    IS(frob_pow(0.0, 3.0), 0.0);
    IS(frob_pow(-0.0, 3.0), -0.0);
    IS(frob_pow(-0.0, 2.5), 0.0);
    IS(frob_pow(-1.0, INFINITY), 1.0);
    IS(frob_pow(-1.0, -INFINITY), 1.0);
    IS(frob_pow(1.0, NAN), 1.0);
    IS(frob_pow(NAN, 0.0), 1.0);
    IS(frob_pow(NAN, -0.0), 1.0);
    IS(frob_pow(NAN, 1.0), NAN);
    IS(frob_pow(2.0, NAN), NAN);
    IS(frob_pow(-2.0, 0.5), NAN);
    IS(frob_pow(-2.0, 3.0), -8.0);
    IS(frob_pow(-2.0, 2.0), 4.0);
    IS(frob_pow(-3.0, 9007199254740993.0), INFINITY);
    IS(frob_pow(0.5, INFINITY), 0.0);
    IS(frob_pow(0.5, -INFINITY), INFINITY);
    IS(frob_pow(2.0, INFINITY), INFINITY);
    IS(frob_pow(2.0, -INFINITY), 0.0);
    IS(frob_pow(INFINITY, -1.0), 0.0);
    IS(frob_pow(INFINITY, 1.0), INFINITY);
    IS(frob_pow(-INFINITY, -3.0), -0.0);
    IS(frob_pow(-INFINITY, -2.5), 0.0);
    IS(frob_pow(-INFINITY, 3.0), -INFINITY);
    IS(frob_pow(-INFINITY, 4.0), INFINITY);
    IS(frob_pow(2.0, 1023.0), 0x1p1023);
    IS(frob_pow(2.0, 1024.0), INFINITY);
    IS(frob_pow(2.0, -1074.0), 0x1p-1074);
    IS(frob_pow(2.0, -1076.0), 0.0);
    IS(frob_pow(0x1.fffffffffffffp-1, 1e300), 0.0);
    IS(frob_pow(0x1.0000000000001p0, 1e300), INFINITY);
    IS(frob_pow(3.0, 1e-300), 1.0);
    IS(frob_pow(10.0, 2.0), 100.0);
    IS(frob_pow(10.0, 15.0), 1e15);
}

static void angles(void)
{
    IS(frob_sin(0.0), 0.0);
    IS(frob_sin(-0.0), -0.0);
    IS(frob_sin(INFINITY), NAN);
    IS(frob_sin(NAN), NAN);
    IS(frob_sin(0x1p-1074), 0x1p-1074);
    IS(frob_cos(0.0), 1.0);
    IS(frob_cos(-0.0), 1.0);
    IS(frob_cos(-INFINITY), NAN);
    IS(frob_tan(-0.0), -0.0);
    IS(frob_tan(INFINITY), NAN);
    /* The double nearest to a multiple of pi/2, and the largest double. */
    IS(frob_cos(0x1.6ac5b262ca1ffp849), -0x1.14ae72e6ba22fp-61);
    IS(frob_sin(0x1.fffffffffffffp1023), 0x1.452fc98b34e97p-8);
}

static void inverses(void)
{
    IS(frob_asin(-0.0), -0.0);
    IS(frob_asin(1.0), 0x1.921fb54442d18p0);
    IS(frob_asin(-1.0), -0x1.921fb54442d18p0);
    IS(frob_asin(1.0000000000000002), NAN);
    IS(frob_asin(NAN), NAN);
    IS(frob_acos(1.0), 0.0);
    IS(frob_acos(-1.0), 0x1.921fb54442d18p1);
    IS(frob_acos(0.0), 0x1.921fb54442d18p0);
    IS(frob_acos(-2.0), NAN);
    IS(frob_atan(-0.0), -0.0);
    IS(frob_atan(1.0), 0x1.921fb54442d18p-1);
    IS(frob_atan(INFINITY), 0x1.921fb54442d18p0);
    IS(frob_atan(-INFINITY), -0x1.921fb54442d18p0);
    IS(frob_atan(NAN), NAN);
    IS(frob_atan2(0.0, 0.0), 0.0);
    IS(frob_atan2(-0.0, 0.0), -0.0);
    IS(frob_atan2(0.0, -0.0), 0x1.921fb54442d18p1);
    IS(frob_atan2(-0.0, -0.0), -0x1.921fb54442d18p1);
    IS(frob_atan2(0.0, -1.0), 0x1.921fb54442d18p1);
    IS(frob_atan2(-0.0, 1.0), -0.0);
    IS(frob_atan2(1.0, 0.0), 0x1.921fb54442d18p0);
    IS(frob_atan2(-1.0, -0.0), -0x1.921fb54442d18p0);
    IS(frob_atan2(1.0, INFINITY), 0.0);
    IS(frob_atan2(-1.0, -INFINITY), -0x1.921fb54442d18p1);
    IS(frob_atan2(INFINITY, 1.0), 0x1.921fb54442d18p0);
    IS(frob_atan2(INFINITY, INFINITY), 0x1.921fb54442d18p-1);
    IS(frob_atan2(-INFINITY, -INFINITY), -0x1.2d97c7f3321d2p1);
    IS(frob_atan2(NAN, 1.0), NAN);
    IS(frob_atan2(1e308, 1e308), 0x1.921fb54442d18p-1);
    IS(frob_atan2(0x1p-1074, 0x1p-1074), 0x1.921fb54442d18p-1);
    IS(frob_hypot(3.0, -4.0), 5.0);
    IS(frob_hypot(INFINITY, NAN), INFINITY);
    IS(frob_hypot(NAN, -INFINITY), INFINITY);
    IS(frob_hypot(NAN, 1.0), NAN);
    IS(frob_hypot(-0.0, -0.0), 0.0);
    IS(frob_hypot(0.0, -2.0), 2.0);
    IS(frob_hypot(1e308, 1e308), 0x1.92c80954c51f5p1023);
    IS(frob_hypot(0x1.8p-1073, 0x1p-1072), 0x1.4p-1072);
}

int main(void)
{
    exponentials();
    powers();
    angles();
    inverses();
    return failed ? 1 : 0;
}
