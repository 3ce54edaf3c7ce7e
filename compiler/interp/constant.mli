(** Evaluates definitions whose values are known before the program runs. *)

type problem =
  | Param of Core.Ir.param  (** the value depends on this parameter *)
  | Foreign of string  (** the value depends on this C function of the user *)
  | Too_much  (** evaluation takes too many steps or nests too deeply *)

type program
(** A program whose definitions are evaluated at most once each, and with a limit on the total
    number of evaluation steps. *)

val program : Core.Ir.program -> program

val value : program -> Core.Ir.Global.t -> (Value.t, problem) result
(** Value of a definition without parameters, if it is a number or a Bool. For a parameter of the
    program: its default, or the given value. For other types, the parts are not evaluated. *)

val known : program -> (unit -> 'a) -> ('a, problem) result
(** Runs a function that forces parts of such values, and returns its result or the problem it met.
*)
