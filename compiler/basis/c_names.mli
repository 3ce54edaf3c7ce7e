(** Names that C and C++ reserve, or that their headers may define as macros, types and functions.
*)

val is_keyword : string -> bool
(** A keyword of C99 or C++17, because generated C must compile as both. *)

val is_taken : string -> bool
(** A keyword, or a name that a compiler or the headers [<math.h>], [<stdint.h>] and [<stdbool.h>]
    may define as a macro or a type. Generated code cannot use such a name for anything. *)

val is_macro_like : string -> bool
(** For example [FP_NAN], [M_PI] or [INT32_MAX]. *)

val is_function : string -> bool
(** A function declared in those headers or in the runtime. A struct member may have such a name. *)

val is_pure : string -> bool
(** A function of [<math.h>] whose result depends only on its arguments. A program may import it
    without providing a source file. *)

val pure : string list
