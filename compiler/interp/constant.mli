(** Evaluates definitions whose values are known before the program runs. *)

type problem =
  | Param of Core.Ir.param  (** the value depends on this parameter *)
  | Foreign of string  (** the value depends on this function from the user's C code *)
  | Too_much  (** evaluation takes too many steps or nests too deeply *)

type program
(** A program in which each definition is evaluated at most once, with a limit on the total number
    of evaluation steps. *)

val program : Core.Ir.program -> program

val value : program -> Core.Ir.Global.t -> (Value.t, problem) result
(** The value of a definition without parameters. A number or a Bool is evaluated completely, but
    the parts of other values are not. The value of a program parameter is its override, if there is
    one, and its default otherwise. *)

val known : program -> (unit -> 'a) -> ('a, problem) result
(** Runs a function that forces parts of such values, and returns its result or the problem that it
    encountered. *)
