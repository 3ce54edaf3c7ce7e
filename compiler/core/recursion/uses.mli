(** The definitions and methods that each definition uses. *)

open Basis

type target =
  | Definition of Ir.Global.t * Ir.ty list
  | Method of { class_ : Ir.Global.t; name : string; ty : Ir.ty; types : Ir.ty list }

type use = {
  target : target;
  span : Span.t;
  later : bool;
      (** whether the use is inside a function that is passed as an argument and returns a signal
          function or a task, such as the continuation of a switch. Such a function runs later, if
          at all *)
}

type t = {
  definitions : Ir.definition array;
  index : int Resolve.Global_table.t;  (** index into [definitions] *)
  uses : use list array;  (** the uses in each definition, in source order *)
}

val of_program : Ir.program -> t
(** Linear time. Does not depend on the invariants that {!Lint} checks. *)

val cycle :
  Ir.definition array ->
  use:(int -> int -> Span.t option) ->
  int list ->
  (Ir.definition * Span.t) list
(** Given the indices of the definitions in a cycle, returns each definition with the place where it
    uses the next one, according to [use]. *)
