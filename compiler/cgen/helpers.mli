(** The C functions that generated code calls: [runtime/include/frob/step.h], whose text is embedded
    in the compiler, and the elementary functions of the runtime. *)

val included : string
(** The line that includes [step.h]. *)

val names : unit -> string list
(** The names that [step.h] defines. *)

val standalone : real:Basis.Real.t -> elementary:(string * string) list -> string -> string
(** Makes a source file self-contained except for the standard headers of C: replaces the line
    {!included} with the definitions that the source needs, directly or indirectly, and appends the
    elementary functions that it calls. [elementary]: names and texts of the files in
    [runtime/elementary]. All added functions are static, and their names start with [frob_]. *)
