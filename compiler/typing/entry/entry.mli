(** Entry points: the definitions that a program can be compiled from. An entry is a signal function
    or a [Program] without type variables.

    Codes: [E0411] the definition cannot be an entry · [E0501] there is no definition of that name.
*)

open Basis

val find : Diagnostic.sink -> Ir.program -> file:string -> string -> Ir.definition option
(** The definition of this name in the main module, whose path is [file]. Emits [E0501] if there is
    none. *)

val no_entry : string
(** The code of that error. *)

val all : Ir.program -> Ir.definition list
(** The entries that [frobc check] examines: `main`, or, in a module without it, every signal
    function that could be an entry. A `main` that cannot be an entry is included, so that it is
    reported. *)

val refusal : Ir.program -> closed:bool -> Ir.definition -> Diagnostic.t option
(** The reason why a definition cannot be an entry; [None] if it can. The message shows the
    definition's type, declared or inferred, before units and classes are erased. [closed]: whether
    the type contains no variables once a robot has been chosen. *)

val is_signed : Resolve.Ir.program -> Ir.Global.t -> bool
(** Does this definition have a type signature? *)
