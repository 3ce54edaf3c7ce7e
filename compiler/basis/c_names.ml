let words text =
  let table = String_table.create 256 in
  List.iter (fun name -> String_table.replace table name ()) (String.split_on_char ' ' text);
  table

let keywords =
  words
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t \
     class compl const const_cast constexpr continue decltype default delete do double \
     dynamic_cast else enum explicit export extern false float for friend goto if inline int long \
     mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public \
     register reinterpret_cast restrict return short signed sizeof static static_assert \
     static_cast struct switch template this thread_local throw true try typedef typeid typename \
     union unsigned using virtual void volatile wchar_t while xor xor_eq"

let is_keyword = String_table.mem keywords

(* Includes keywords of later C++ standards. *)
let taken =
  words
    "char8_t co_await co_return co_yield concept consteval constinit import module override \
     requires typeof complex imaginary noreturn errno linux unix i386 INFINITY NAN HUGE_VAL NULL \
     EOF DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS float_t double_t int8_t int16_t int32_t \
     int64_t uint8_t uint16_t uint32_t uint64_t intptr_t uintptr_t intmax_t uintmax_t size_t \
     ptrdiff_t"

let is_macro_like name =
  let starts prefix = String.starts_with ~prefix name in
  name <> ""
  && Char.uppercase_ascii name.[0] = name.[0]
  && List.exists starts
       [ "FP_"; "M_"; "MATH_"; "INT"; "UINT"; "FLT_"; "DBL_"; "SIZE_MAX"; "WCHAR"; "WINT" ]

let is_taken name = is_keyword name || String_table.mem taken name || is_macro_like name

let pure =
  String.split_on_char ' '
    "acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf erfc exp exp2 expm1 \
     fabs fdim floor fma fmax fmin fmod hypot ilogb ldexp log log10 log1p log2 logb nextafter pow \
     remainder round scalbn sin sinh sqrt tan tanh tgamma trunc"

let is_pure name = List.mem name pure

let functions =
  words
    "drem exp10 finite fpclassify frexp gamma isfinite isgreater isgreaterequal isinf isless \
     islessequal islessgreater isnan isnormal isunordered j0 j1 jn lgamma llrint llround lrint \
     lround modf nan nearbyint nexttoward pow10 remquo rint scalb scalbln signbit signgam \
     significand sincos y0 y1 yn abs div labs time clock main std frob_exp frob_log frob_pow \
     frob_sin frob_cos frob_tan frob_asin frob_acos frob_atan frob_atan2 frob_hypot frob_reduce"

let is_function name = is_pure name || String_table.mem functions name
