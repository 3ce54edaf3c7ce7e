(** What is said about definitions that need themselves. *)

open Basis

type vertex = { name : string;  (** may be empty *) span : Span.t }

val diagnostic : vertex:(int -> vertex) -> use:(int -> int -> Span.t) -> int list -> Diagnostic.t
(** E0410 for a cycle, not empty: each vertex uses the next, the last one the
    first; [use]: where. *)
