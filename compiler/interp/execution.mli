(** A program that runs: the entry's signal function, from its first instant. *)

type t

val interface : Core.Ir.program -> Core.Ir.Global.t -> Core.Ir.ty * Core.Ir.ty
(** The types of the input and the output of an entry. *)

val start :
  ?params:(Core.Ir.Global.t * Value.t) list -> Core.Ir.program -> entry:Core.Ir.Global.t -> t
(** [params]: the values of parameters that do not have those they have by default. The entry is a
    signal function or a program, of a closed type; what the compiler would reject has no meaning
    here. *)

val ended : t -> Core.Ir.ty option
(** The type of what the program ends with, if it says when it has ended: then each output is a
    pair, of the program's output and the event of its end. *)

val instant : ?precision:Basis.Real.t -> t -> seconds:float -> Value.t -> Value.t
(** The output, wholly evaluated, for the input. [seconds]: since the instant before; not looked at
    in the first. [precision]: theirs, double unless said; hosts have doubles whatever the program
    computes with, only [NAME_step] of a program in single precision is given singles. *)
