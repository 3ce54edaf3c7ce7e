(** The message about definitions that depend on themselves. *)

open Basis

type vertex = {
  name : string;
  span : Span.t;
  task : bool;  (** is it a task, or a function that returns one? *)
  function_ : bool;  (** is it a function or a signal function? *)
}

val vertex : Ir.definition -> vertex

val diagnostic : vertex:(int -> vertex) -> use:(int -> int -> Span.t) -> int list -> Diagnostic.t
(** The error E0410 for a non-empty cycle in which each vertex uses the next one, and the last one
    uses the first. [use]: the place of a use. Shows only the beginning and the last step of a very
    long cycle. *)
