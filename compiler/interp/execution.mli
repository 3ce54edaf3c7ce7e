(** A running program: the entry's signal function, from its first instant on. *)

type t

val interface : Core.Ir.program -> Core.Ir.Global.t -> Core.Ir.ty * Core.Ir.ty
(** The types of the input and the output of an entry. *)

val start :
  ?params:(Core.Ir.Global.t * Value.t) list -> Core.Ir.program -> entry:Core.Ir.Global.t -> t
(** [params]: the values of parameters that differ from their defaults. The entry must be a signal
    function or a program with a closed type. For programs that the compiler would reject, the
    behaviour is undefined. *)

val ended : t -> Core.Ir.ty option
(** The type of the result, if the program can end. In that case, each output is a pair of the
    program's output and the event that signals its end. *)

val instant : ?precision:Basis.Real.t -> t -> seconds:float -> Value.t -> Value.t
(** Runs one instant and returns the output, completely evaluated. [seconds] is the time since the
    previous instant; the first instant ignores it. [precision] is the precision of [seconds]. The
    default is double, because hosts pass doubles whatever the precision of the program; only the
    function [NAME_step] of a single-precision program takes a float. *)
