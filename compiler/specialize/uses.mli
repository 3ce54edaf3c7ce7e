(** The definitions and methods that an expression mentions. *)

open Basis

type target =
  | Definition of Core.Ir.Global.t * Core.Ir.ty list
  | Method of {
      class_ : Core.Ir.Global.t;
      name : string;
      ty : Core.Ir.ty;
      types : Core.Ir.ty list;
    }

val of_expr : continuations:bool -> Core.Ir.expr -> (target * Span.t) list
(** In the order of the text. [continuations]: also in what
    {!Cycle.is_continuation} says is one. *)
