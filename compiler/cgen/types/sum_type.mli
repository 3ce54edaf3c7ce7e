(** Sums in C: a struct with a tag and shared slots, constants for the tags, functions that
    construct values, and functions that extract inner sums. *)

type t = {
  struct_name : string;
  tags : string array;  (** constants, by constructor *)
  makers : string array;  (** functions that construct values, by constructor *)
  real : Basis.Real.t;  (** the type of its Floats *)
  slots : Step.Layout.slots;
  arrays : (Flow.Ir.ty * Ir.ty) list;  (** array types with their structs *)
}

val name :
  Name.scope ->
  prefix:string ->
  real:Basis.Real.t ->
  Flow.Ir.sum ->
  slots:Step.Layout.slots ->
  arrays:(Flow.Ir.ty * Ir.ty) list ->
  t
(** Chooses names that are unused in the file's scope. *)

(** The place of a payload's leaf. *)
type slot =
  | Scalar of string  (** a member, which may be an array *)
  | Inner of { sum : int; tag : string; first : Step.Layout.slots }
      (** [tag]: the member for the inner sum's tag. [first]: the slots that precede those of the
          inner sum *)

val payload : Flow.Ir.sum array -> ?first:Step.Layout.slots -> Flow.Ir.sum_constructor -> slot list
(** The place of each leaf in a payload whose slots follow the slots [first]. *)

val zero :
  Basis.Real.t ->
  Flow.Ir.sum array ->
  absent:(Flow.Ir.foreign_type -> Ir.expr) ->
  Step.Ir.ty ->
  Ir.expr
(** An arbitrary initial value of the type. *)

(** The kind of value that a member contains. *)
type kind =
  | Number
  | Whole
  | Truth
  | Inner_tag
  | Large of Flow.Ir.ty  (** an array, or a foreign value *)

val kinds :
  Flow.Ir.sum array -> ?first:Step.Layout.slots -> Step.Layout.slots -> (string * kind) list
(** The members of a struct for these slots, which follow the slots [first]. *)

val members : Flow.Ir.sum array -> ?first:Step.Layout.slots -> t -> (string * Ir.ty) list
(** The members with their types. *)

val definition : Flow.Ir.sum array -> Flow.Ir.sum -> t -> Ir.declaration list
(** The constants for the tags, and the struct. *)

val maker :
  Flow.Ir.sum array ->
  absent:(Flow.Ir.foreign_type -> Ir.expr) ->
  t array ->
  int ->
  int ->
  Ir.function_
(** The function that constructs a value of this sum with this constructor. *)

val projection : Flow.Ir.sum array -> t array -> int -> constructor:int -> leaf:int -> Ir.function_
(** The function that extracts the inner sum at this leaf of the payload. *)
