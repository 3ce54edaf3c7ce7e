(** Collects what the body of a function reads. *)

open Basis

type t = {
  variables : unit Int_table.t;  (** variables that are read, by id *)
  mutable seconds : bool;  (** whether dt is read in seconds *)
  mutable nanoseconds : bool;  (** whether dt is read in nanoseconds *)
  mutable operations : int;  (** number of expressions that have subexpressions *)
}

val of_body : Ir.statement list -> t

val parameters : t -> Ir.variable list -> Ir.variable list
(** The parameters that are read. *)
