(** What the statements of a function have in common, and calls of nodes. *)

open Basis
module M = Step.Ir

type t = {
  v : Vocabulary.t;
  names : Expression.names;
  index : int;
  node : M.node;
  write : int -> Ir.expr -> Ir.statement;  (** an output *)
  read : unit Basis.Int_table.t;  (** variables that anything reads *)
  mutable place : string;  (** the source line last mentioned *)
}

val plain : Ir.statement_desc -> Ir.statement

val comment : t -> Span.t -> string
(** The source line of a statement, unless the one before mentions it. *)

val expression : t -> M.expr -> Ir.expr

val declared : t -> (M.variable * string) list -> Ir.statement list
(** Declarations without values, one for each run of equal types, of variables by these names. *)

val uninitialized : t -> M.variable list -> Ir.statement list
(** Likewise, last first. *)

val in_seconds : t -> Ir.expr -> Ir.expr
(** Of nanoseconds, 64 bits. *)

val step_call : t -> node:int -> own:Ir.expr list -> Ir.expr list -> Ir.expr list -> Ir.expr
(** With the address of the state, if there is one, arguments and results. *)

val own_state : t -> M.field option -> Ir.expr list
(** The address. *)

val for_step : t -> int -> M.expr list -> Ir.expr list
(** The arguments of a node's step. *)

val for_reset : t -> int -> M.expr list -> Ir.expr list
