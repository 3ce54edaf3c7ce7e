(** What a function has to compute, before it is decided where.

    {!Body} describes a reset or step function so; {!Usage} decides which values stand inside their
    user's expression, {!Write_order} in which order the state is written, {!Placement} in which
    block each value is computed.

    Always true: an item's operands are leaves or defined by items before it; operands are never
    copies of other signals. *)

open Basis

type atom = Flow.Ir.atom

type computed = {
  signal : Flow.Ir.signal;
  operands : atom list;
  build : Ir.expr list -> Ir.expr;  (** from the operands' expressions *)
  choice : (atom * atom * atom) option;  (** condition, then, else *)
  weight : int;  (** about how many additions it costs *)
  span : Span.t;
}
(** A value without effect. It may be computed anywhere or not at all. *)

type action = {
  defines : Flow.Ir.signal list;
  operands : atom list;
  statements : Ir.expr list -> Ir.statement list;
  always : bool;  (** it writes state, and so belongs to every step *)
  advances : Ir.field option;  (** one that it writes, and items after it read *)
  weight : int;
  span : Span.t;
}
(** Statements that define variables. *)

type item = Computed of computed | Action of action

(** How a place is to change at the end of the step. *)
type update = Keep | Set of atom | Branch of { condition : atom; then_ : update; else_ : update }

type write = { place : Ir.place; update : update; span : Span.t }

type t = {
  leaves : Ir.expr Int_table.t;
      (** signals that are read in place: parameters, the program's too, state *)
  nanoseconds : unit Int_table.t;
      (** signals that are whole nanoseconds, for which Flow has no type *)
  items : item array;
  results : (Ir.place * atom * Span.t) list;
      (** written before any state; those that {!Late} finds come after it *)
  states : (Ir.field * atom * Flow.Ir.signal option * Span.t) list;
      (** field, its next value, and the signal whose leaf the field is: that value means that the
          field keeps what it has *)
  returned : (atom * Span.t) option;
  advances : Ir.statement list;  (** of times and integrals: before all else *)
  ending : ending option;  (** see {!Early_end}; [returned] is [None] then *)
}

and ending = { ends : atom; told : int; span : Span.t }
(** Where this holds a mode ends, and then only its [results] from [told] on count. *)
