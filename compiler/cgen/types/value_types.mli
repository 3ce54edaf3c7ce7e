(** The structs for a program's sums and arrays, in one precision.

    A program in single precision has two of these tables: one for the program itself, with floats,
    and one for the user's C code, with doubles. Types without Floats are only in the first table,
    and both sides share them. *)

(** The owner of a type. The owner's header defines the type. *)
type owner =
  | Program
  | Robot
  | Foreign_code  (** the program, but the type has a name that the user's C code can use *)

type t

type known
(** The types that are also used outside the program. *)

val known : Flow.Ir.sum array -> known

val mark : known -> owner -> Flow.Ir.shape -> unit
(** Records that this owner uses all types in the shape. The first owner of a type keeps it. *)

val own : Name.scope -> name:string -> real:Basis.Real.t -> known -> t
(** The program's own table. [name] is the prefix for types that the program owns. *)

val of_foreign_code : t -> t
(** The table for the user's C code; in double precision, it is the program's own table. *)

val sums : t -> Sum_type.t array

val ty : t -> Step.Ir.ty -> Ir.ty
(** The struct of an array is named when it is first used. *)

val foreign_type : Flow.Ir.foreign_type -> Ir.ty

val array_name : t -> Step.Ir.ty -> string
(** The name of an array's struct. *)

val differ : t -> Step.Ir.ty -> bool
(** Whether values of this type are represented differently in the user's C code and in the program.
*)

type definition
(** A struct, with the constants for its tags if it is a sum. *)

val definitions : t -> of_:(owner -> bool) -> definition list
(** The definitions of all types whose owner satisfies [of_], each before its uses. Call this after
    all code has been generated. *)

val reached : definition list -> from:string list -> definition list * definition list
(** Splits definitions into two lists, keeping their order: the structs in [from] and everything
    that these consist of, and all other definitions. *)

val declarations : definition list -> Ir.declaration list

val defined : string -> string
(** The macro that marks this struct as defined. *)

val once : string -> Ir.declaration list -> Ir.declaration list
(** Wraps the declarations so that they have an effect only if the struct is not defined yet. *)
