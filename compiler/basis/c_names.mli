(** Names that C and C++ have already, or that their headers may give to macros, types and
    functions. *)

val is_keyword : string -> bool
(** Of C99 or C++17: generated C is both. *)

val is_taken : string -> bool
(** Keywords, and what compilers and the headers [<math.h>], [<stdint.h>] and [<stdbool.h>] may
    define as a macro or a type; nothing can be called so. *)

val is_macro_like : string -> bool
(** [FP_NAN], [M_PI], [INT32_MAX]… *)

val is_function : string -> bool
(** Declared by those headers, or the runtime's; a member of a struct may be called so. *)

val is_pure : string -> bool
(** A function of [<math.h>] whose result rests on its arguments alone: a program may import it
    without a file that has it. *)

val pure : string list
