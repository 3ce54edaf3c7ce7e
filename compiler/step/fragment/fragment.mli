(** The computations of a function, before the compiler decides where to place them.

    {!Body} translates a reset or step function to a fragment. {!Usage} decides which values are
    inlined into the expressions that use them, {!Write_order} decides in which order the state is
    written, and {!Placement} decides in which block each value is computed.

    Invariants: an item's operands are leaves or are defined by preceding items; operands are never
    copies of other signals. *)

open Basis

type atom = Flow.Ir.atom

type computed = {
  signal : Flow.Ir.signal;
  operands : atom list;
  build : Ir.expr list -> Ir.expr;  (** builds the expression from the operands' expressions *)
  choice : (atom * atom * atom) option;  (** condition, then, else *)
  weight : int;  (** approximate cost, in additions *)
  span : Span.t;
}
(** A value without side effects. It may be computed anywhere, or not at all. *)

type action = {
  defines : Flow.Ir.signal list;
  operands : atom list;
  statements : Ir.expr list -> Ir.statement list;
  always : bool;  (** whether the action writes state; such an action is never omitted *)
  advances : Ir.field option;  (** a field that the action writes and later items read *)
  weight : int;
  span : Span.t;
}
(** Statements that define variables, write state, or both. *)

type item = Computed of computed | Action of action

(** An update of a place at the end of the step. *)
type update = Keep | Set of atom | Branch of { condition : atom; then_ : update; else_ : update }

type write = { place : Ir.place; update : update; span : Span.t }

type t = {
  leaves : Ir.expr Int_table.t;
      (** expressions for signals that are read directly: state, and parameters of the function or
          the program *)
  nanoseconds : unit Int_table.t;
      (** signals that contain whole numbers of nanoseconds; Flow does not have a type for them *)
  items : item array;
  results : (Ir.place * atom * Span.t) list;
      (** written before any state, except for the results that {!Late} writes afterwards *)
  states : (Ir.field * atom * Flow.Ir.signal option * Span.t) list;
      (** a field, its next value, and the signal that the step reads from the field, if any. If the
          next value is that signal, the field does not change *)
  returned : (atom * Span.t) option;
  advances : Ir.statement list;
      (** statements that advance times and integrals, executed before everything else *)
  ending : ending option;  (** see {!Early_end}; if present, [returned] is [None] *)
}

and ending = { ends : atom; told : int; span : Span.t }
(** If [ends] is true, the mode ends. In that case, only the [results] with index [told] or higher
    are needed. *)
