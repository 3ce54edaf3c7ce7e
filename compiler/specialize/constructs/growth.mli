(** Signal functions that get larger each time they start themselves again.

    [go sf = switch sf (\\_ -> go (sf >>> g))] would have a mode for each number of [g]s. Numbers do
    not count, so a mode that comes after one of the same code and with a deeper nest of functions
    in it, again and again, will have another like it for ever. *)

open Basis

type t
(** Of a mode, with what led to it. *)

val of_value : Value.t -> at:Span.t -> from:t option -> t
(** [at]: where the mode before makes it; [from]: of that mode. *)

val is_endless : t -> bool

val report : Context.t -> name:string -> t -> 'a
(** E0416, or E0420 of a task that is not called last; raises {!Context.Stopped}. *)
