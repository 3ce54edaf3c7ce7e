(** What a function's body turned out to read. *)

type t = {
  variables : (int, unit) Hashtbl.t;  (** by id *)
  mutable seconds : bool;  (** dt as a number *)
  mutable nanoseconds : bool;  (** dt as a whole number of nanoseconds *)
  mutable operations : int;  (** how many expressions have parts *)
}

val of_body : Ir.statement list -> t

val parameters : t -> Ir.variable list -> Ir.variable list
(** Those that are read. *)
