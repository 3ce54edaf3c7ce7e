(** The context for generating the statements of a function, and functions that generate
    declarations and calls to the functions of nodes. *)

open Basis
module M = Step.Ir

type t = {
  v : Program_names.t;
  names : Expression.names;
  index : int;
  node : M.node;
  write : int -> Ir.expr -> Ir.statement;  (** assigns a value to an output *)
  read : unit Basis.Int_table.t;  (** the variables that are read *)
  mutable place : string;  (** the source line in the last comment *)
}

val plain : Ir.statement_desc -> Ir.statement

val comment : t -> Span.t -> string
(** A comment with the source line of a statement, unless the previous comment has the same line. *)

val expression : t -> M.expr -> Ir.expr

val value : t -> at:Span.t -> M.expr -> Ir.expr
(** Translates the value of the statement at this place ({!Expression.operand}). *)

val declared : t -> (M.variable * string) list -> Ir.statement list
(** Declares variables with these names without initial values. Consecutive variables of the same
    type share a declaration. *)

val uninitialized : t -> M.variable list -> Ir.statement list
(** Like {!declared}, but with the variables' own names, and in reverse order. *)

val in_seconds : Program_names.t -> Ir.expr -> Ir.expr
(** Converts 64-bit nanoseconds to seconds. *)

val step_call :
  ?entered:bool -> t -> node:int -> own:Ir.expr list -> Ir.expr list -> Ir.expr list -> Ir.expr
(** Calls a node's step with the address of the state, if there is one, the arguments and the
    results. [entered]: passes a dt of 0, for a mode that was entered in this instant; false by
    default. *)

val own_state : t -> M.field option -> Ir.expr list
(** The address of a state, as a list with one element; empty if there is no state. *)

val for_step : t -> int -> M.expr list -> Ir.expr list
(** The arguments for a node's step. *)

val for_reset : t -> int -> M.expr list -> Ir.expr list
