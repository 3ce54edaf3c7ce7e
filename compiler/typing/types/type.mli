(** Types while they are inferred.

    As {!Ir.ty}, with variables still to be found, with the names of aliases kept for messages (an
    alias equals its expansion), and with a type that agrees with everything, so that one mistake is
    reported once. *)

type t =
  | Flexible of flexible  (** to be found *)
  | Rigid of rigid  (** quantified *)
  | Number of representation * Units.t
  | Bool
  | String
  | Tuple of t list
  | Function of t * t
  | Signal_function of t * t
  | Data of { tycon : Ir.Global.t; units : Units.t list; arguments : t list }
  | Alias of { alias : Ir.Global.t; units : Units.t list; arguments : t list; expansion : t }
  | Size of int  (** of an array; only as an argument *)
  | Erroneous  (** of something that was reported *)

and flexible = {
  id : int;
  kind : kind;
  mutable depth : int;
  mutable found : t option;
  mutable final : final option;  (** kept by {!Final}, once inference is over *)
}

and final = {
  ty : Ir.ty;
  parts : int;  (** constructors of types in it, written out *)
  nesting : int;
}

and rigid = { variable : Ir.variable; kind : kind; depth : int  (** as {!Units.rigid} *) }

(** What a variable, and a parameter of a type, stands for. *)
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
(** Of numbers for variables: one for a program. *)

val supply : unit -> supply
val next : supply -> int

(** {1 New variables} *)

val fresh : supply -> ?kind:kind -> depth:int -> unit -> t
(** Of types unless said. *)

val fresh_representation : supply -> depth:int -> representation
val fresh_unit : supply -> depth:int -> Units.t

val fresh_number : supply -> depth:int -> t
(** A number of any representation and unit. *)

(** {1 Looking at a type} *)

val kind : t -> kind

val repr : t -> t
(** Past what was found; an alias stays. *)

val expand : t -> t
(** Past what was found and past aliases. *)

val representation : representation -> representation

val shared : t -> t
(** The same type, converted only once however often it occurs: for types that an expression adds a
    layer to. *)

(** {1 Using a scheme} *)

type instance = {
  ty : t;
  type_arguments : t list;
  representation_arguments : representation list;
  required : (Ir.class_ * t) list;
}

val instantiate : supply -> depth:int -> scheme -> instance

val mentions : Ir.variable -> t -> bool
(** Does a quantified type variable occur in the type? *)

val occurs : flexible -> t -> bool
(** Likewise of a variable to be found. *)

val substitute : types:(rigid * t) list -> units:(Units.rigid * Units.t) list -> t -> t
