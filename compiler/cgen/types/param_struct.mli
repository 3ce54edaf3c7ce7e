(** The parameters of a program as a struct, and their defaults as a constant of that type. *)

type t

val of_program : Name.scope -> name:string -> Step.Ir.program -> t option
(** [None] if the program has no parameters. *)

val struct_name : t -> string

val defaults : t -> string
(** The name of the constant. *)

val member : t -> int -> string
(** The member for the parameter with this index. *)

val definition : t -> Step.Ir.program -> string
(** The definition of the struct, with doc comments, and the declaration of the constant. *)

val values : t -> Step.Ir.program -> string
(** The definition of the constant. *)
