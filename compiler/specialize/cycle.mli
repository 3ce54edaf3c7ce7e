(** What is said about definitions that need themselves. *)

open Basis

type vertex = { name : string; span : Span.t; task : bool  (** or gives one *) }

val gives_task : Core.Ir.ty -> bool
(** Itself, or applied. *)

val is_continuation : Core.Ir.ty -> bool
(** Of an argument: is it, as that of a switch, a function that gives a signal
    function, or a task? What it mentions runs later, if at all, and is followed from mode
    to mode (see {!Machine}). *)

val diagnostic : vertex:(int -> vertex) -> use:(int -> int -> Span.t) -> int list -> Diagnostic.t
(** E0410 for a cycle, not empty: each vertex uses the next, the last one the
    first; [use]: where. Of a long one the beginning and the last step. *)
