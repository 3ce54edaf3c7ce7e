(** Type constructors, by which class instances are selected. *)

type t =
  | Data of Ir.Global.t
  | Int
  | Float
  | Bool
  | String
  | Tuple of int  (** number of components *)
  | Function
  | Signal_function

val of_type : Type.t -> (t * Type.t list) option
(** The type constructor and its type arguments (without unit arguments). A number of undetermined
    representation counts as [Float], its default. [None] for a variable and for an erroneous type.
*)

val parameters : Type.t -> Type.rigid list option
(** The type variables, in order, if the type is a constructor applied to distinct variables. Unit
    arguments must be distinct variables too. *)
