(** An argument of an application. *)

open Basis

type t = {
  value : Resolve.Ir.expr;
  style : Resolve.Ir.apply_style;
  span : Span.t;  (** span of the whole application *)
  position : int;  (** counted from 1 *)
}
