(** What one run of the resolver carries along: where diagnostics go, the counter of local
    variables, and how deep the present expression is. *)

open Basis

type t

val create : Diagnostic.sink -> t

val emit : t -> Diagnostic.t -> unit
(** What is said of an unknown name waits for {!tell}. *)

val is_told : t -> (Diagnostic.t -> bool) -> bool
(** Something of this kind is said of an unknown name already. *)

val fresh : t -> string -> Span.t -> Ir.Local.t
(** A new local variable. *)

val nested : t -> Span.t -> otherwise:'a -> (unit -> 'a) -> 'a
(** Runs a function one level deeper. Beyond 10,000 levels, where the stack would be in danger, it
    emits E0106, once, and gives [otherwise]. *)

type absent = { imports : string list; code : string; noun : string; name : Syntax.Ir.name }
(** A name that is in the library, but not imported; any of these declarations would. *)

val not_imported : t -> absent -> unit

val add_import : Syntax.Ir.program -> string -> Diagnostic.t -> Diagnostic.t
(** Adds the fix that writes this import below those of the module. *)

val tell : t -> Syntax.Ir.program -> unit
(** At the end of this module: emits one diagnostic for each import that is missing, and for each
    name that is not known, wherever it stands. *)

val suggest : t -> string -> string list Lazy.t -> Diagnostic.t -> Diagnostic.t
(** Adds a hint with the nearest of the names, and the fix that writes it where the diagnostic is.
    Looks only for the first hundred names of a run: a list of suggestions as long as the program
    helps nobody and takes quadratic time. *)
