(** The text of a type or a unit in Frob syntax. Final types and inferred types are both converted
    to this tree, so that one printer handles both. *)

type tree =
  | Word of string
  | Applied of string * tree list
  | Arrow of tree * tree
  | Group of tree list  (** a tuple *)

val applied : string -> tree list -> tree
(** The head alone if there are no arguments. *)

val write : tree -> string

val product : (string * Rational.t) list -> string
(** A product of named powers, in this order, with negative powers after a slash: [kg m/s^2]. *)

val base_names : (Ir.Global.t * Rational.t) list -> (string * Rational.t) list

val bracketed : string -> string list -> string
(** A name with its units: [Vec[m, s]]. *)

val number : [ `Named of string | `Variable of string ] -> string -> string
(** A type of numbers, given its representation and unit. [Float[1]] is written [Float]; [n[1]]
    keeps its brackets. *)
