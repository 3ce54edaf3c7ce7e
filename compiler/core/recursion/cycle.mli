(** What is said about definitions that need themselves. *)

open Basis

type vertex = {
  name : string;
  span : Span.t;
  task : bool;  (** or gives one *)
  function_ : bool;  (** or a signal function *)
}

val vertex : Ir.definition -> vertex

val diagnostic : vertex:(int -> vertex) -> use:(int -> int -> Span.t) -> int list -> Diagnostic.t
(** E0410 for a cycle, not empty: each vertex uses the next, the last one the first; [use]: where.
    Of a long one the beginning and the last step. *)
