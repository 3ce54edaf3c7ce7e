(** Types, units and signatures as written in the source. *)

open Basis

type scope
(** The variables that the signatures around a place have named. *)

val empty : scope

val of_parameters :
  (Resolve.Ir.parameter * Units.rigid) list -> (Resolve.Ir.parameter * Type.rigid) list -> scope
(** Of a declaration: units, types. *)

val with_type : string -> Type.rigid -> scope -> scope

type t = { environment : Environment.t; supply : Type.supply; sink : Diagnostic.sink }
(** What reading a type needs. *)

val ty : t -> scope -> Resolve.Ir.ty -> Type.t
(** No size. All its variables are in scope. A unit of scale other than 1 is [E0321]. *)

val any : t -> scope -> Resolve.Ir.ty -> Type.t
(** A type or a size; all its variables are in scope. What stands for the wrong one of them inside
    is [E0330], a size out of range [E0333]. *)

val parameter_kinds : t -> Resolve.Ir.ty list -> string -> Type.kind
(** What a parameter stands for, by its name, from where these types use it. *)

val unit_ : t -> scope -> Resolve.Ir.unit_ -> Environment.unit_
(** With its exact scale. A scaled unit to a power that is no integer is [E0322]; exponents out of
    range are [E0323]. *)

val class_ : Ir.Global.t -> Ir.class_

val signature : t -> scope -> depth:int -> Resolve.Ir.scheme -> Type.scheme * scope
(** Quantifies the variables that the scope does not have, in the order in which they occur, at
    [depth]; the new scope has them too. *)
