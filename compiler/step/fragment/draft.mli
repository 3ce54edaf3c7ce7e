(** A fragment under construction, which resolves unnamed copies. *)

open Basis

type t

val create : unit -> t

val resolve : t -> Flow.Ir.atom -> Flow.Ir.atom
(** The original of the atom if the atom is a copy; otherwise the atom itself. *)

val add : t -> Fragment.item -> unit

val add_computed : t -> Flow.Ir.equation -> unit
(** Adds a stateless equation. *)

val leaf : t -> Flow.Ir.signal -> Ir.expr -> unit
(** Records that every read of this signal uses this expression directly. *)

val count_nanoseconds : t -> Flow.Ir.signal -> unit
(** Records that the signal is a whole number of nanoseconds, regardless of its type in Flow. *)

val keep_at_end : t -> Ir.field -> Flow.Ir.atom -> leaf:Flow.Ir.signal option -> Span.t -> unit
(** Assigns this value to the field at the end of the step. [leaf]: the signal that the step reads
    from the field, if any. *)

val work :
  ?defines:Flow.Ir.signal list ->
  ?operands:Flow.Ir.atom list ->
  ?always:bool ->
  ?advances:Ir.field ->
  ?weight:int ->
  Span.t ->
  (Ir.expr list -> Ir.statement list) ->
  Fragment.item
(** An action. By default, it writes state, defines no variables, and has almost no cost. *)

val fragment : t -> Fragment.t
(** The resulting fragment, with the states recorded by {!keep_at_end}. *)
