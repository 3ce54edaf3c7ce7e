(** What is said about definitions that need themselves. *)

open Basis

type vertex = { name : string;  (** may be empty *) span : Span.t; task : bool  (** or gives one *) }

val gives_task : Core.Ir.ty -> bool
(** Itself, or applied. *)

val is_continuation : Core.Ir.ty -> bool
(** Of an argument: is it, as that of a switch, a function that gives a signal
    function, or a task? What it mentions runs later, if at all, and is followed from mode
    to mode (see {!Machine}). *)

val is_static : Core.Ir.equation -> bool
(** Is it a function, a signal function or something with one in it, and no signal? *)

val diagnostic : vertex:(int -> vertex) -> use:(int -> int -> Span.t) -> int list -> Diagnostic.t
(** E0410 for a cycle, not empty: each vertex uses the next, the last one the
    first; [use]: where. Of a long one the beginning and the last step. *)
