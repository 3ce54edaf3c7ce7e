/* OCaml wrappers for the elementary functions. They take and return doubles, because OCaml has no
 * other floating-point type. The bytecode versions take boxed doubles. A single is a double whose
 * value a C float can represent exactly. */
#include <caml/alloc.h>
#include <caml/mlvalues.h>
#include <frob/elementary.h>

#define ONE(name)                                                   \
    value frob_boxed_##name(value x)                                \
    {                                                               \
        return caml_copy_double(frob_##name(Double_val(x)));        \
    }                                                               \
    double frob_single_##name(double x)                             \
    {                                                               \
        return (double)frob_##name##f((float)x);                    \
    }                                                               \
    value frob_boxed_single_##name(value x)                         \
    {                                                               \
        return caml_copy_double(frob_single_##name(Double_val(x))); \
    }

#define TWO(name)                                                                  \
    value frob_boxed_##name(value x, value y)                                      \
    {                                                                              \
        return caml_copy_double(frob_##name(Double_val(x), Double_val(y)));        \
    }                                                                              \
    double frob_single_##name(double x, double y)                                  \
    {                                                                              \
        return (double)frob_##name##f((float)x, (float)y);                         \
    }                                                                              \
    value frob_boxed_single_##name(value x, value y)                               \
    {                                                                              \
        return caml_copy_double(frob_single_##name(Double_val(x), Double_val(y))); \
    }

ONE(exp)
ONE(log)
ONE(sin)
ONE(cos)
ONE(tan)
ONE(asin)
ONE(acos)
ONE(atan)
TWO(pow)
TWO(atan2)
TWO(hypot)
