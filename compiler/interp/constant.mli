(** Values of definitions that are known before a program runs. *)

type problem =
  | Param of Core.Ir.param  (** it depends on this one *)
  | Foreign of string  (** or on C code of the user's *)

val value : Core.Ir.program -> Core.Ir.Global.t -> (Value.t, problem) result
(** Of a definition without parameters, of a number or a Bool; of a parameter by its default, or as
    it is given. Of other types the parts are not evaluated. *)

val known : (unit -> 'a) -> ('a, problem) result
(** What a function finds out that demands parts of such values. *)
