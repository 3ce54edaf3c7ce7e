(** What a function's body turned out to read. *)

open Basis

type t = {
  variables : unit Int_table.t;  (** by id *)
  mutable seconds : bool;  (** dt as a number *)
  mutable nanoseconds : bool;  (** dt as a whole number of nanoseconds *)
  mutable operations : int;  (** how many expressions have parts *)
}

val of_body : Ir.statement list -> t

val parameters : t -> Ir.variable list -> Ir.variable list
(** Those that are read. *)
