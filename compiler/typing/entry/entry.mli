(** Entry points: the definitions that a program can be compiled from. An entry is a signal function
    or a [Program] without type variables.

    Codes: [E0411] the definition cannot be an entry · [E0501] there is no definition with that
    name. *)

open Basis

val find : Fact.t Facts.t -> Ir.program -> file:string -> string -> Ir.definition option
(** The definition with this name in the main module, whose path is [file]. Reports [E0501] if there
    is none. *)

val all : Ir.program -> Ir.definition list
(** The entries that [frobc check] examines: `main`, or, in a module without it, every signal
    function that could be an entry. A `main` that cannot be an entry is included, so that it is
    reported. *)

val accepts : Fact.t Facts.t -> Ir.program -> closed:bool -> Ir.definition -> bool
(** Can the definition be an entry? Reports [E0411] if it cannot. Its type may be declared or
    inferred; units and classes have not been erased yet. [closed]: whether the type contains no
    variables once a robot has been chosen. *)

val is_signed : Resolve.Ir.program -> Ir.Global.t -> bool
(** Does this definition have a type signature? *)
