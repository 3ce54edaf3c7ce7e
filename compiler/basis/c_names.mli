(** Names that C and C++ reserve, or that their headers may define as macros, types and functions.
*)

val is_keyword : string -> bool
(** Is this a keyword of C99 or C++17? Generated code must compile as both. *)

val is_taken : string -> bool
(** Is this a keyword, or a name that a compiler or one of the headers [<math.h>], [<stdint.h>] and
    [<stdbool.h>] may define as a macro or a type? Generated code must not use such a name at all.
*)

val is_macro_like : string -> bool
(** Does this look like a macro, for example [FP_NAN], [M_PI] or [INT32_MAX]? *)

val is_function : string -> bool
(** Do the headers listed in {!is_taken}, or the runtime, declare a function with this name? A
    struct member may have such a name. *)

val is_pure : string -> bool
(** Is this a function of [<math.h>] whose result depends only on its arguments? A program may
    import it without providing a source file. *)

val pure : string list
