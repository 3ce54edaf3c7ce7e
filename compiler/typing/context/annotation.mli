(** Converts types, units and signatures from the source. *)

open Basis

type scope
(** The type variables that enclosing signatures have introduced. *)

val empty : scope

val of_parameters :
  (Resolve.Ir.parameter * Units.rigid) list -> (Resolve.Ir.parameter * Type.rigid) list -> scope
(** The unit and type parameters of a declaration. *)

val with_type : string -> Type.rigid -> scope -> scope

type t = { environment : Environment.t; supply : Type.supply; facts : Fact.t Facts.t }
(** Context for converting a type. *)

val ty : t -> scope -> Resolve.Ir.ty -> Type.t
(** Converts a type that is not a size. All its variables must be in scope. A unit whose scale is
    not 1 is reported as [E0321]. *)

val any : t -> scope -> Resolve.Ir.ty -> Type.t
(** Converts a type or a size. All its variables must be in scope. A size where a type is required,
    or the reverse, is reported as [E0330]; a size out of range as [E0333]. *)

val parameter_kinds : t -> Resolve.Ir.ty list -> string -> Type.kind
(** The kind (type or size) of a parameter with this name, inferred from its uses in these types. *)

val unit_ : t -> scope -> Resolve.Ir.unit_ -> Environment.unit_
(** Converts a unit and computes its exact scale. A scaled unit raised to a fractional power is
    reported as [E0322], an exponent out of range as [E0323]. *)

val together : t -> (unit -> 'a) -> 'a
(** Runs the function. If it reports the same scaled unit several times on one line, combines these
    reports into a single fact. *)

val class_ : Ir.Global.t -> Ir.class_

val signature : t -> scope -> depth:int -> Resolve.Ir.scheme -> Type.scheme * scope
(** Quantifies over the variables that are not in scope, in order of occurrence, at [depth]. Also
    returns the scope extended with them. *)

val nowhere : Environment.t -> Surroundings.t
(** Surroundings with this environment and no other information about the program. *)

val report_declaration : t -> Declaration_fact.t -> unit
(** Reports a fact about a declaration that is not part of a definition. *)
