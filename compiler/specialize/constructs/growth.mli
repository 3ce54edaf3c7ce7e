(** Detects signal functions that grow each time they restart themselves.

    [go sf = switch sf (\\_ -> go (sf >>> g))] would need a separate mode for each number of [g]s. A
    mode that differs only in its numbers has not grown. If many modes follow each other with the
    same code but ever more deeply nested functions, the sequence is assumed to be infinite. *)

open Basis

type t
(** The growth history of a mode: its own size and the modes that led to it. *)

val of_value : Value.t -> at:Span.t -> from:t option -> t
(** [at]: the place where the previous mode creates this one. [from]: the history of the previous
    mode. *)

val is_endless : t -> bool

val report : Context.t -> name:string -> t -> 'a
(** Reports the growth, or, for a task, that the recursive call is not in tail position, and raises
    {!Context.Stopped}. *)
