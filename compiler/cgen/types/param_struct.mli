(** The parameters of a program as a struct, and their defaults as a constant of it. *)

type t

val of_program : Name.scope -> name:string -> Step.Ir.program -> t option
(** [None] of a program without parameters. *)

val struct_name : t -> string

val defaults : t -> string
(** The constant's name. *)

val member : t -> int -> string
(** Of the parameter of that number. *)

val definition : t -> Step.Ir.program -> string
(** Of the struct with its doc comments, and the constant's declaration. *)

val values : t -> Step.Ir.program -> string
(** The constant's definition. *)
