(** What a program can be compiled from: a signal function or a program whose type is known to the
    end.

    Codes: [E0411] another definition · [E0501] there is none of that name. *)

open Basis

val find : Diagnostic.sink -> Ir.program -> file:string -> string -> Ir.definition option
(** A definition of the main module, which is [file]. Emits [E0501] if there is none. *)

val no_entry : string
(** Its code. *)

val all : Ir.program -> Ir.definition list
(** What a check looks into: `main`, or, in a module without one, every signal function that could
    be an entry. A `main` that cannot be one is told so. *)

val refusal : Ir.program -> closed:bool -> Ir.definition -> Diagnostic.t option
(** Why a definition is no entry, said before units and classes are gone, in the type that its
    signature has or would have; [None] if it is one. [closed]: by a robot, so that no variable of
    the type is left. *)

val is_signed : Resolve.Ir.program -> Ir.Global.t -> bool
(** Does the programmer say the type of this definition? *)
