(** What is said of arguments that are missing, or one too many. *)

open Basis

val declared : Show.words -> Resolve.Ir.expr option -> (string * string) option
(** The head of an application, with its type as its signature has it. *)

val missing_arguments : Type.t -> int
(** How many arguments such a value still takes. *)

val lacking_arguments :
  Show.words -> subject:Resolve.Ir.expr option -> int -> Diagnostic.t -> Diagnostic.t option
(** So many are missing where this local, or what it stands for, was defined. *)

val one_too_many :
  Show.words -> subject:Resolve.Ir.expr option -> wanted:Type.t -> Diagnostic.t -> Diagnostic.t
(** Of the result of a function that was wanted itself. *)

val input_given : Show.words -> Resolve.Ir.expr option -> Type.t -> string option
(** The last argument, if it is the input of the proc around, and such an input is what the
    application, of this type, still wants last: what is missing comes before it. *)
