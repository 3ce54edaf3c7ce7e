(** The C that generated code calls: [runtime/include/frob/step.h], whose text comes along in the
    compiler, and the elementary functions of the runtime. *)

val included : string
(** The line that includes [step.h]. *)

val names : unit -> string list
(** Those that [step.h] defines. *)

val standalone : real:Basis.Real.t -> elementary:(string * string) list -> string -> string
(** The text of a source, with what it calls, and what that calls in turn, in place of the line
    {!included} and at its end; so it needs only C's own headers. [elementary]: names and texts of
    the files of [runtime/elementary]. All that comes in is static, its names begin with [frob_]. *)
