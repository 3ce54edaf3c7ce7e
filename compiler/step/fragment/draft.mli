(** A fragment under construction. Unnamed copies are looked through. *)

open Basis

type t

val create : unit -> t

val resolve : t -> Flow.Ir.atom -> Flow.Ir.atom
(** What an atom is a copy of. *)

val add : t -> Fragment.item -> unit

val add_computed : t -> Flow.Ir.equation -> unit
(** An equation without memory. *)

val leaf : t -> Flow.Ir.signal -> Ir.expr -> unit
(** The signal is read in place, as this. *)

val count_nanoseconds : t -> Flow.Ir.signal -> unit
(** The signal is a whole number of nanoseconds, whatever its type in Flow. *)

val keep_at_end : t -> Ir.field -> Flow.Ir.atom -> leaf:Flow.Ir.signal option -> Span.t -> unit
(** A field gets this value at the end of the step; [leaf] as in {!Fragment.t}. *)

val work :
  ?defines:Flow.Ir.signal list ->
  ?operands:Flow.Ir.atom list ->
  ?always:bool ->
  ?advances:Ir.field ->
  ?weight:int ->
  Span.t ->
  (Ir.expr list -> Ir.statement list) ->
  Fragment.item
(** Statements; if nothing else is said they write state, define no variable and cost next to
    nothing. *)

val fragment : t -> Fragment.t
(** All so far; its states are those of {!keep_at_end}. *)
