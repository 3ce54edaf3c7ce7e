type t =
  | Wrap
  | Int_add
  | Int_subtract
  | Int_multiply
  | Int_negate
  | Int_absolute
  | Int_signum
  | Int_minimum
  | Int_maximum
  | Int_div
  | Int_mod
  | Bit_and
  | Bit_or
  | Bit_xor
  | Shift_left
  | Shift_right
  | Float_add
  | Float_subtract
  | Float_minimum
  | Float_maximum
  | Least
  | Largest
  | At_most
  | At_least
  | Where
  | Limit
  | Float_signum
  | Truncate
  | Floor
  | Ceiling
  | Round
  | Whole_nanoseconds
  | Dt_nanoseconds
  | Whole_dt
  | Seconds
  | Time_in_nanoseconds
  | Time_span
  | Later
  | Soon
  | Reached
  | Rest
  | Branch
  | Restrict
  | Shared
  | One_copy

(* Helper, its name, what it calls (earlier in the table), its text. *)
let table =
  [
    ( Branch,
      "FROB_BRANCH",
      [],
      {|/* The condition of a branch that is to stay one, for the processor to predict:
 * a select in its place would have each step wait for the one before. */
#ifdef __GNUC__
#define FROB_BRANCH(condition) (__builtin_expect((condition), 0) != 0)
#else
#define FROB_BRANCH(condition) (condition)
#endif
|} );
    ( Restrict,
      "FROB_RESTRICT",
      [],
      {|/* What this pointer leads to no other does that is written through. Compilers could
 * not know: modes have structs that may share memory with any other. */
#ifndef __cplusplus
#define FROB_RESTRICT restrict
#elif defined(__GNUC__)
#define FROB_RESTRICT __restrict__
#else
#define FROB_RESTRICT
#endif
|} );
    ( Shared,
      "FROB_SHARED",
      [],
      {|/* A step that several modes have in common, of which one runs at an instant: copies
 * would make the program larger and no faster. For size compilers know best. */
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define FROB_SHARED __attribute__((__noinline__))
#else
#define FROB_SHARED
#endif
|} );
    ( One_copy,
      "FROB_ONE_COPY",
      [],
      {|/* What several modes do, of which one runs at an instant: each has its own copy,
 * but where size counts. */
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define FROB_ONE_COPY __attribute__((__noinline__))
#else
#define FROB_ONE_COPY inline
#endif
|} );
    ( Wrap,
      "frob_wrap",
      [],
      {|/* The number that a 32-bit register holds, read as signed. */
static inline int32_t frob_wrap(uint32_t u)
{
    const uint32_t above = u - 0x80000000u;
    return u <= 0x7fffffffu ? (int32_t)u : (int32_t)above + INT32_MIN;
}
|} );
    ( Int_add,
      "frob_int_add",
      [ Wrap ],
      {|static inline int32_t frob_int_add(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a + (uint32_t)b);
}
|} );
    ( Int_subtract,
      "frob_int_sub",
      [ Wrap ],
      {|static inline int32_t frob_int_sub(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a - (uint32_t)b);
}
|} );
    ( Int_multiply,
      "frob_int_mul",
      [ Wrap ],
      {|static inline int32_t frob_int_mul(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a * (uint32_t)b);
}
|} );
    ( Int_negate,
      "frob_int_neg",
      [ Wrap ],
      {|static inline int32_t frob_int_neg(int32_t a)
{
    return frob_wrap(0u - (uint32_t)a);
}
|} );
    ( Int_absolute,
      "frob_int_abs",
      [ Int_negate ],
      {|/* The least integer is its own absolute value. */
static inline int32_t frob_int_abs(int32_t a)
{
    return a < 0 ? frob_int_neg(a) : a;
}
|} );
    ( Int_signum,
      "frob_int_signum",
      [],
      {|static inline int32_t frob_int_signum(int32_t a)
{
    return a > 0 ? 1 : a < 0 ? -1 : 0;
}
|} );
    ( Int_minimum,
      "frob_int_min",
      [],
      {|static inline int32_t frob_int_min(int32_t a, int32_t b)
{
    return b < a ? b : a;
}
|} );
    ( Int_maximum,
      "frob_int_max",
      [],
      {|static inline int32_t frob_int_max(int32_t a, int32_t b)
{
    return b > a ? b : a;
}
|} );
    ( Int_div,
      "frob_int_div",
      [ Int_negate ],
      {|/* Rounds to minus infinity; by 0 gives 0. */
static inline int32_t frob_int_div(int32_t a, int32_t b)
{
    if (b == 0) {
        return 0;
    }
    if (b == -1) {
        return frob_int_neg(a);
    }
    return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}
|} );
    ( Int_mod,
      "frob_int_mod",
      [],
      {|/* Has the sign of the divisor; by 0 gives 0. */
static inline int32_t frob_int_mod(int32_t a, int32_t b)
{
    int32_t rest;
    if (b == 0 || b == -1) {
        return 0;
    }
    rest = a % b;
    return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}
|} );
    ( Bit_and,
      "frob_int_and",
      [ Wrap ],
      {|static inline int32_t frob_int_and(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a & (uint32_t)b);
}
|} );
    ( Bit_or,
      "frob_int_or",
      [ Wrap ],
      {|static inline int32_t frob_int_or(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a | (uint32_t)b);
}
|} );
    ( Bit_xor,
      "frob_int_xor",
      [ Wrap ],
      {|static inline int32_t frob_int_xor(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a ^ (uint32_t)b);
}
|} );
    ( Shift_left,
      "frob_int_shift_left",
      [ Wrap ],
      {|/* By a negative number to the right, where the sign stays; by 32 or more, what as
 * many by 1 come to. */
static inline int32_t frob_int_shift_left(int32_t a, int32_t by)
{
    const uint32_t sign = a < 0 ? 0xffffffffu : 0u;
    if (by < 0) {
        return frob_wrap((((uint32_t)a ^ sign) >> (by < -31 ? 31 : -by)) ^ sign);
    }
    return by > 31 ? 0 : frob_wrap((uint32_t)a << by);
}
|} );
    ( Shift_right,
      "frob_int_shift_right",
      [ Shift_left ],
      {|static inline int32_t frob_int_shift_right(int32_t a, int32_t by)
{
    return frob_int_shift_left(a, by < -32 ? 32 : -by);
}
|} );
    ( Float_add,
      "frob_add",
      [],
      {|/* Of a zero; a function, for gcc 12 folds fabs(x) in such a sum to the wrong zero. */
static inline @R frob_add(@R a, @R b)
{
    return a + b;
}
|} );
    ( Float_subtract,
      "frob_subtract",
      [],
      {|/* From a zero; a function, for gcc 12 folds 0.0 - fabs(x) to the wrong zero. */
static inline @R frob_subtract(@R a, @R b)
{
    return a - b;
}
|} );
    ( Float_minimum,
      "frob_min",
      [ Branch ],
      {|/* NaN if either is; the first of two equal ones. */
static inline @R frob_min(@R a, @R b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b < a ? b : a;
}
|} );
    ( Float_maximum,
      "frob_max",
      [ Branch ],
      {|/* NaN if either is; the first of two equal ones. */
static inline @R frob_max(@R a, @R b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b > a ? b : a;
}
|} );
    ( Least,
      "frob_least",
      [ Branch ],
      {|/* The smaller, the first of two equal ones; a number rather than NaN. */
static inline @R frob_least(@R a, @R b)
{
    const @R less = b < a ? b : a;
    if (FROB_BRANCH(less != less)) {
        return b;
    }
    return less;
}
|} );
    ( Largest,
      "frob_largest",
      [ Branch ],
      {|/* The larger, the first of two equal ones; a number rather than NaN. */
static inline @R frob_largest(@R a, @R b)
{
    const @R more = b > a ? b : a;
    if (FROB_BRANCH(more != more)) {
        return b;
    }
    return more;
}
|} );
    ( At_most,
      "frob_at_most",
      [],
      {|/* The minimum with a limit that is not NaN; NaN if x is. */
static inline @R frob_at_most(@R x, @R limit)
{
    return limit < x ? limit : x;
}
|} );
    ( At_least,
      "frob_at_least",
      [],
      {|/* The maximum with a limit that is not NaN; NaN if x is. */
static inline @R frob_at_least(@R x, @R limit)
{
    return limit > x ? limit : x;
}
|} );
    ( Where,
      "frob_where",
      [],
      {|/* x where the condition holds, else 0.0. Looked up: of a choice gcc would make a
 * branch, which from one element of an array to the next a processor guesses wrong. */
static inline @R frob_where(bool condition, @R x)
{
    const @R choice[2] = {0.0@f, x};
    return choice[condition ? 1 : 0];
}
|} );
    ( Limit,
      "frob_limit",
      [ Branch ],
      {|/* max (-x) (min x y): y within x of 0; NaN if either is. */
static inline @R frob_limit(@R x, @R y)
{
    if (FROB_BRANCH(y != y)) {
        return y;
    }
    const @R high = y < x ? y : x;
    return high > -x ? high : -x;
}
|} );
    ( Float_signum,
      "frob_signum",
      [],
      {|/* Of a zero or NaN, itself. */
static inline @R frob_signum(@R x)
{
    return x > 0.0@f ? 1.0@f : x < 0.0@f ? -1.0@f : x;
}
|} );
    ( Truncate,
      "frob_truncate",
      [],
      {|/* To an integer, toward 0; saturates, and NaN gives 0. */
static inline int32_t frob_truncate(@R x)
{
    if (x >= 2147483648.0@f) {
        return INT32_MAX;
    }
    if (x <= -2147483648.0@f) {
        return INT32_MIN;
    }
    return x == x ? (int32_t)x : 0;
}
|} );
    ( Floor,
      "frob_floor",
      [ Branch ],
      {|/* The greatest integer that is not above; saturates, and NaN gives 0. */
static inline int32_t frob_floor(double x)
{
    if (FROB_BRANCH(x != x)) {
        return 0;
    }
    const double high = x < 2147483647.0 ? x : 2147483647.0;
    const double inside = high > -2147483648.0 ? high : -2147483648.0;
    const int32_t n = (int32_t)inside;
    return n - ((double)n > inside ? 1 : 0);
}
|} );
    ( Ceiling,
      "frob_ceiling",
      [ Branch ],
      {|/* The least integer that is not below; saturates, and NaN gives 0. */
static inline int32_t frob_ceiling(double x)
{
    if (FROB_BRANCH(x != x)) {
        return 0;
    }
    const double low = x > -2147483648.0 ? x : -2147483648.0;
    const double inside = low < 2147483647.0 ? low : 2147483647.0;
    const int32_t n = (int32_t)inside;
    return n + ((double)n < inside ? 1 : 0);
}
|} );
    ( Round,
      "frob_round",
      [ Truncate ],
      {|/* To the nearest integer, halves away from 0. */
static inline int32_t frob_round(@R x)
{
    const int32_t n = frob_truncate(x);
    const @R rest = x - (@R)n;
    if (rest >= 0.5@f && n < INT32_MAX) {
        return n + 1;
    }
    return rest <= -0.5@f && n > INT32_MIN ? n - 1 : n;
}
|} );
    ( Whole_nanoseconds,
      "frob_whole_ns",
      [ Branch ],
      {|/* dt in nanoseconds, a whole number of them, halves to even: adding 2^52
 * leaves no bits for a fraction. NaN and negative give 0; at most 1e9 s. */
static inline double frob_whole_ns(double dt)
{
    double ns = (1e9 < dt ? 1e9 : dt) * 1e9;
    if (FROB_BRANCH(ns >= 4503599627370496.0)) {
        return ns;
    }
    ns = ns > 0.0 ? ns : 0.0;
    return (ns + 4503599627370496.0) - 4503599627370496.0;
}
|} );
    ( Dt_nanoseconds,
      "frob_dt_ns",
      [ Whole_nanoseconds; One_copy ],
      {|/* The same as an integer. */
static FROB_ONE_COPY int64_t frob_dt_ns(double dt)
{
    return (int64_t)frob_whole_ns(dt);
}
|} );
    ( Whole_dt,
      "frob_whole_dt",
      [ Whole_nanoseconds ],
      {|/* dt rounded to whole nanoseconds, in seconds. Almost always dt is the double nearest
 * to such a number already, and its bits tell that sooner than a division: from 2^-10
 * to 2^22 s they, times 4e9 and shifted left by the exponent, are the fraction of a
 * nanosecond in 64 bits, and 4e9, shifted alike, is as much as a step of dt's last bit. */
static inline double frob_whole_dt(double dt)
{
#ifndef __OPTIMIZE_SIZE__
    const uint64_t last_bit = 4000000000u;
    uint64_t bits;
    (void)memcpy(&bits, &dt, sizeof bits);
    const uint32_t exponent = (uint32_t)(bits >> 52) - 1013u;
    if (exponent < 32u
        && (bits * last_bit + last_bit / 2u) << exponent <= last_bit << exponent) {
        return dt;
    }
#endif
    return frob_whole_ns(dt) / 1e9;
}
|} );
    ( Seconds,
      "frob_seconds",
      [ Branch ],
      {|/* Whole nanoseconds in seconds. Almost always that is the dt they come from, and
 * then what is divided by it waits for one division, not for two: worth the bytes
 * where these do not count.
 * (Adding 0.0 makes 0.0 of -0.0.) */
static inline double frob_seconds(double ns, double dt)
{
    const double s = ns / 1e9;
#ifndef __OPTIMIZE_SIZE__
    if (!FROB_BRANCH(s != dt)) {
        return dt + 0.0;
    }
#endif
    (void)dt;
    return s;
}
|} );
    ( Time_in_nanoseconds,
      "frob_time_in_ns",
      [ Branch ],
      {|/* A local time in nanoseconds, as they are made of its seconds; for the first
 * 13 days the roundings leave no trace. */
static inline double frob_time_in_ns(int64_t time)
{
    double ns = (double)time;
    if (FROB_BRANCH(time >= INT64_C(0x4000000000000))) {
        ns = ns / 1e9 * 1e9;
        return ns < 4503599627370496.0 ? (ns + 4503599627370496.0) - 4503599627370496.0 : ns;
    }
    return ns;
}
|} );
    ( Time_span,
      "frob_span",
      [],
      {|/* A dt in nanoseconds: not negative, at most 1e18. */
static inline int64_t frob_span(int64_t dt_ns)
{
    const int64_t most = INT64_C(1000000000000000000);
    return dt_ns > 0 ? (dt_ns < most ? dt_ns : most) : 0;
}
|} );
    ( Later,
      "frob_later",
      [],
      {|/* A local time after some more nanoseconds; stops at the end of time. */
static inline int64_t frob_later(int64_t time, int64_t ns)
{
    const uint64_t later = (uint64_t)time + (uint64_t)ns;
    return later < (uint64_t)INT64_MAX ? (int64_t)later : INT64_MAX;
}
|} );
    ( Soon,
      "frob_soon",
      [],
      {|/* A local time after some more nanoseconds, where it stays far from the end of time. */
static inline int64_t frob_soon(int64_t time, int64_t ns)
{
    const uint64_t soon = (uint64_t)time + (uint64_t)ns;
    return (int64_t)soon;
}
|} );
    ( Reached,
      "frob_reached",
      [],
      {|/* Has a time in nanoseconds come to so many? Not if that is NaN. */
static inline bool frob_reached(int64_t time, @R period)
{
    return period < 9223372036854775808.0@f && (period < 0.0@f || (int64_t)period <= time);
}
|} );
    ( Rest,
      "frob_rest",
      [],
      {|/* Of a time that has come to a period, what is left after whole ones. */
static inline int64_t frob_rest(int64_t time, @R period)
{
    return period < 1.0@f ? 0 : time % (int64_t)period;
}
|} );
  ]

(* In single precision time is counted in integers, and seconds are only read; the
   greatest integer is no float. *)
let single_text t text =
  match t with
  | Whole_nanoseconds ->
      {|/* dt in nanoseconds: of whole seconds and of their fraction, for a float has too
 * few bits for both. Halves to even: adding 2^23 leaves no bits for a fraction.
 * NaN and negative give 0; at most 1e9 s. */
static inline int64_t frob_whole_ns(float dt)
{
    if (!(dt > 0.0f)) {
        return 0;
    }
    if (dt >= 1e9f) {
        return INT64_C(1000000000000000000);
    }
    const int32_t s = (int32_t)dt;
    float ns = (dt - (float)s) * 1e9f;
    if (ns < 8388608.0f) {
        ns = (ns + 8388608.0f) - 8388608.0f;
    }
    return (int64_t)s * 1000000000 + (int32_t)ns;
}
|}
  | Time_in_nanoseconds ->
      {|/* A local time in nanoseconds, as they are made of its seconds: adding 2^23 leaves
 * no bits for a fraction. */
static inline float frob_time_in_ns(int64_t time)
{
    const float ns = (float)time / 1e9f * 1e9f;
    return ns < 8388608.0f ? (ns + 8388608.0f) - 8388608.0f : ns;
}
|}
  | Floor ->
      {|static inline int32_t frob_floor(float x)
{
    const int32_t n = frob_truncate(x);
    return (float)n > x && n > INT32_MIN ? n - 1 : n;
}
|}
  | Ceiling ->
      {|static inline int32_t frob_ceiling(float x)
{
    const int32_t n = frob_truncate(x);
    return (float)n < x && n < INT32_MAX ? n + 1 : n;
}
|}
  | _ -> text

let single_calls t calls =
  match t with
  | Whole_nanoseconds | Time_in_nanoseconds -> []
  | Floor | Ceiling -> [ Truncate ]
  | _ -> calls

(* In the table @R stands for the type of a Float, @f for what ends its literals. *)
let in_precision (real : Basis.Real.t) text =
  match String.split_on_char '@' text with
  | [] -> text
  | first :: marked ->
      let expand piece =
        let rest = String.sub piece 1 (String.length piece - 1) in
        (match piece.[0] with 'R' -> Print.real_name real | _ -> Print.real_suffix real) ^ rest
      in
      String.concat "" (first :: List.map expand marked)

let name t =
  match List.find_opt (fun (other, _, _, _) -> other = t) table with
  | Some (_, name, _, _) -> name
  | None -> Basis.Diagnostic.bug ~stage:"Cgen.Helper" "a helper without a row"

let names = List.map (fun (_, name, _, _) -> name) table

(* From the last row to the first, so that callers come before callees. *)
let text ~(real : Basis.Real.t) wanted =
  let needed = Hashtbl.create 16 in
  List.fold_left
    (fun texts (t, _, calls, text) ->
      if wanted t || Hashtbl.mem needed t then (
        let calls = match real with Double -> calls | Single -> single_calls t calls in
        List.iter (fun callee -> Hashtbl.replace needed callee ()) calls;
        let text = match real with Double -> text | Single -> single_text t text in
        in_precision real text :: texts)
      else texts)
    [] (List.rev table)
