(** Type constructors: what an instance of a class is chosen by. *)

type t =
  | Data of Ir.Global.t
  | Int
  | Float
  | Bool
  | String
  | Tuple of int  (** of that many parts *)
  | Function
  | Signal_function

val of_type : Type.t -> (t * Type.t list) option
(** With what it is applied to, but for units. A number whose representation nothing has decided is
    a [Float], as it will be. [None] for a variable, and for what was reported. *)

val parameters : Type.t -> Type.rigid list option
(** Of a type that is a constructor applied to distinct variables, of types and of units: those of
    types, in order. *)
