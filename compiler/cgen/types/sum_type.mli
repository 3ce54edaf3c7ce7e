(** Sums in C: a struct of a tag and shared slots, constants for the tags, and functions that
    construct values and take inner sums out again. *)

type t = {
  struct_name : string;
  tags : string array;  (** constants, by constructor *)
  makers : string array;  (** functions, by constructor *)
  real : Basis.Real.t;  (** of its Floats *)
  slots : Step.Layout.slots;
  arrays : (Flow.Ir.ty * Ir.ty) list;  (** their structs *)
}

val name :
  Name.scope ->
  prefix:string ->
  real:Basis.Real.t ->
  Flow.Ir.sum ->
  slots:Step.Layout.slots ->
  arrays:(Flow.Ir.ty * Ir.ty) list ->
  t
(** Takes names of the file's scope. *)

(** Where the leaves of a payload lie. *)
type slot =
  | Scalar of string  (** a member; of an array too *)
  | Inner of { sum : int; tag : string; first : Step.Layout.slots }
      (** its tag's member; its slots start after [first] *)

val payload : Flow.Ir.sum array -> ?first:Step.Layout.slots -> Flow.Ir.sum_constructor -> slot list
(** The slots of all leaves; [first] slots belong to others. *)

val zero :
  Basis.Real.t ->
  Flow.Ir.sum array ->
  absent:(Flow.Ir.foreign_type -> Ir.expr) ->
  Step.Ir.ty ->
  Ir.expr
(** Some value of the type, as an initial value. *)

(** What a member holds. *)
type kind =
  | Number
  | Whole
  | Truth
  | Inner_tag
  | Large of Flow.Ir.ty  (** an array, or a foreign value *)

val kinds :
  Flow.Ir.sum array -> ?first:Step.Layout.slots -> Step.Layout.slots -> (string * kind) list
(** The members that a struct has for these slots; [first] slots belong to others. *)

val members : Flow.Ir.sum array -> ?first:Step.Layout.slots -> t -> (string * Ir.ty) list
(** The same, with their types. *)

val definition : Flow.Ir.sum array -> Flow.Ir.sum -> t -> Ir.declaration list
(** The tags' constants and the struct. *)

val maker :
  Flow.Ir.sum array ->
  absent:(Flow.Ir.foreign_type -> Ir.expr) ->
  t array ->
  int ->
  int ->
  Ir.function_
(** Of a sum and a constructor. *)

val projection : Flow.Ir.sum array -> t array -> int -> constructor:int -> leaf:int -> Ir.function_
(** The inner sum that is this leaf of the payload. *)
