(** The definitions and methods that definitions mention. *)

open Basis

type target =
  | Definition of Ir.Global.t * Ir.ty list
  | Method of { class_ : Ir.Global.t; name : string; ty : Ir.ty; types : Ir.ty list }

type use = {
  target : target;
  span : Span.t;
  later : bool;
      (** in an argument that, as that of a switch, is a function that gives a signal function or a
          task: it runs later, if at all *)
}

type t = {
  definitions : Ir.definition array;
  index : int Resolve.Global_table.t;  (** in [definitions] *)
  uses : use list array;  (** of each, in the order of the text *)
}

val of_program : Ir.program -> t
(** Linear. Does not need what {!Lint} checks. *)
