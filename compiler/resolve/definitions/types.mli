(** Resolves types, units and signatures: looks up names, checks arities, and distinguishes units
    from unit variables. *)

(** The type variables allowed in a type. *)
type variables =
  | Quantified  (** in a signature: any variables *)
  | Parameters of { units : Interface.String_set.t; types : Interface.String_set.t; owner : string }
      (** in a declaration of the type [owner]: only its parameters, and no [n[u]] *)

val ty : Scope.t -> variables -> Syntax.Ir.ty -> Ir.ty

val context : Scope.t -> (Syntax.Ir.qualified * Syntax.Ir.ty) list -> Ir.constraint_ list
(** The constraints before [=>]. Reports an unknown class. *)

val scheme : Scope.t -> Syntax.Ir.qualified_type -> Ir.scheme

val concrete_unit : Scope.t -> Syntax.Ir.unit_ -> Ir.unit_
(** A unit without variables, as in a literal or a unit declaration. *)

val missing : Basis.Span.t -> Ir.ty
(** Placeholder for a type that could not be resolved. *)
