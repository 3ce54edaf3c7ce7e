/* What bytecode calls: the same functions on OCaml's boxed numbers. */
#include <caml/alloc.h>
#include <caml/mlvalues.h>
#include <frob/elementary.h>

#define ONE(name)                              \
  value frob_boxed_##name(value x) {           \
    return caml_copy_double(frob_##name(Double_val(x))); \
  }

#define TWO(name)                              \
  value frob_boxed_##name(value x, value y) {  \
    return caml_copy_double(frob_##name(Double_val(x), Double_val(y))); \
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
