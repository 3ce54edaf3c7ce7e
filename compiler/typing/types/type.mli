(** Types during inference.

    They differ from {!Ir.ty} in three ways: they may contain unsolved variables, they keep the
    names of aliases for messages (an alias equals its expansion), and they include an erroneous
    type that unifies with everything, so that each mistake is reported once. *)

type t =
  | Flexible of flexible  (** an unsolved or solved variable *)
  | Rigid of rigid  (** a quantified variable *)
  | Number of representation * Units.t
  | Bool
  | String
  | Tuple of t list
  | Function of t * t
  | Signal_function of t * t
  | Data of { tycon : Ir.Global.t; units : Units.t list; arguments : t list }
  | Alias of { alias : Ir.Global.t; units : Units.t list; arguments : t list; expansion : t }
  | Size of int  (** array size; occurs only as a type argument *)
  | Erroneous  (** the type of an expression in which an error has been reported *)

and flexible = {
  id : int;
  kind : kind;
  mutable depth : int;
  mutable found : t option;
  mutable final : final option;  (** cached by {!Final} after inference *)
}

and final = {
  ty : Ir.ty;
  parts : int;  (** number of type constructors in the expanded type *)
  nesting : int;
}

and rigid = { variable : Ir.variable; kind : kind; depth : int  (** see {!Units.rigid} *) }

(** The kind of a variable or type parameter: it ranges over types or sizes. *)
and kind = Of_types | Of_sizes

and representation =
  | Int
  | Float
  | Flexible_representation of flexible_representation
  | Rigid_representation of Units.rigid

and flexible_representation = {
  id : int;
  mutable depth : int;
  mutable found : representation option;
}

type scheme = {
  types : rigid list;
  representations : Units.rigid list;
  units : Units.rigid list;
  context : (Ir.class_ * t) list;
  body : t;
}

val monomorphic : t -> scheme

type supply
(** Supply of ids for variables; one per program. *)

val supply : unit -> supply
val next : supply -> int

(** {1 New variables} *)

val fresh : supply -> ?kind:kind -> depth:int -> unit -> t
(** A type variable, unless [kind] specifies a size variable. *)

val fresh_representation : supply -> depth:int -> representation
val fresh_unit : supply -> depth:int -> Units.t

val fresh_number : supply -> depth:int -> t
(** A number of unknown representation and unit. *)

(** {1 Inspecting a type} *)

val kind : t -> kind

val repr : t -> t
(** Follows solved variables, but keeps aliases. *)

val expand : t -> t
(** Follows solved variables and expands aliases. *)

val representation : representation -> representation

val shared : t -> t
(** A type that is equal to this one, but whose final form is computed only once. Useful for a type
    that many expressions extend by one layer. *)

(** {1 Instantiating a scheme} *)

type instance = {
  ty : t;
  type_arguments : t list;
  representation_arguments : representation list;
  required : (Ir.class_ * t) list;
}

val instantiate : supply -> depth:int -> scheme -> instance

val mentions : Ir.variable -> t -> bool
(** Does the quantified type variable occur in the type? *)

val substitute : types:(rigid * t) list -> units:(Units.rigid * Units.t) list -> t -> t
