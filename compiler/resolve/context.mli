(** The state of one run of the resolver: the diagnostics, the counter of local variables, and the
    nesting depth of the current expression. *)

open Basis

type t

val create : Diagnostic.sink -> t

val emit : t -> Diagnostic.t -> unit
(** Emits the diagnostic. A diagnostic about an unknown name is held back until {!tell} is called.
*)

val holds_many : t -> bool
(** Are at least 1,000 diagnostics held back? *)

val is_told : t -> (Diagnostic.t -> bool) -> bool
(** Does a held-back diagnostic satisfy the predicate? *)

val fresh : t -> string -> Span.t -> Ir.Local.t
(** A new local variable. *)

val nested : t -> Span.t -> otherwise:'a -> (unit -> 'a) -> 'a
(** Runs a function one nesting level deeper. Beyond 10,000 levels the stack could overflow, so it
    emits E0106 (once) and returns [otherwise]. *)

type absent = {
  imports : string list;
  listed : Syntax.Ir.import option;
      (** an import of the name's module with a list of names that does not contain this name *)
  code : string;
  noun : string;
  name : Syntax.Ir.name;
}
(** A library name that is not imported. Any one of these import declarations would bring it into
    scope. *)

val not_imported : t -> absent -> unit
val import_place : Syntax.Ir.program -> Ir.import_place

val add_import : Syntax.Ir.program -> string -> Diagnostic.t -> Diagnostic.t
(** Adds the fix that inserts this import below the module's imports. *)

val tell : t -> Syntax.Ir.program -> unit
(** Must be called at the end of a module. Emits one diagnostic for each missing import, and one for
    each unknown name with all its places. *)

val suggest : t -> string -> string list Lazy.t -> Diagnostic.t -> Diagnostic.t
(** Adds a hint with the closest of the names, and the fix that replaces the name at the
    diagnostic's place. Only the first hundred unknown names of a run get suggestions: computing
    them takes quadratic time, and a longer list would not be read. *)
