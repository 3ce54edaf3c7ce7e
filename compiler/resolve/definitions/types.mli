(** Types, units and signatures: their names looked up, their arguments counted, and units told from
    unit variables. *)

(** The variables that may stand in a type. *)
type variables =
  | Quantified  (** a signature: any *)
  | Parameters of { units : Interface.String_set.t; types : Interface.String_set.t; owner : string }
      (** a declaration of the type [owner]: its parameters; no [n[u]] *)

val ty : Scope.t -> variables -> Syntax.Ir.ty -> Ir.ty

val context : Scope.t -> (Syntax.Ir.qualified * Syntax.Ir.ty) list -> Ir.constraint_ list
(** What stands before [=>]. Emits E0223 for a class that is unknown. *)

val scheme : Scope.t -> Syntax.Ir.qualified_type -> Ir.scheme

val concrete_unit : Scope.t -> Syntax.Ir.unit_ -> Ir.unit_
(** A unit without variables, as in a literal or a unit's declaration. *)

val missing : Basis.Span.t -> Ir.ty
(** Stands for a type that could not be resolved. *)
