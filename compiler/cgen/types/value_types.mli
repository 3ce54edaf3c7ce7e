(** The structs of a program's sums and arrays, in one precision.

    A program of single precision has two such tables: its own, of floats, and that of the user's C,
    of doubles. What holds no number is in the first only, and the same for both. *)

(** Whose header defines a type. *)
type owner =
  | Program
  | Robot
  | Foreign_code  (** the program's, for others to know it by the same name *)

type t

type known
(** What others than the program know of its types. *)

val known : Flow.Ir.sum array -> known

val mark : known -> owner -> Flow.Ir.shape -> unit
(** That one knows what is in this; who comes first owns it. *)

val own : Name.scope -> name:string -> real:Basis.Real.t -> known -> t
(** The program's; [name] is the prefix of what it owns. *)

val of_foreign_code : t -> t
(** As the user's C has the types of the program's own table: that table itself in double precision.
*)

val sums : t -> Sum_type.t array

val ty : t -> Step.Ir.ty -> Ir.ty
(** An array's struct is named where it is first asked for. *)

val foreign_type : Flow.Ir.foreign_type -> Ir.ty

val array_name : t -> Step.Ir.ty -> string
(** Of an array's struct. *)

val differ : t -> Step.Ir.ty -> bool
(** Has the user's C other values of this type than the program's own table? *)

val definitions : t -> of_:(owner -> bool) -> Ir.declaration list
(** Used ones before users. To be called when all code is made. *)

val defined : string -> string
(** The macro that says that this struct is defined. *)

val once : string -> Ir.declaration list -> Ir.declaration list
(** Unless that struct was defined before. *)
