(** Named constants of the program.

    Step contains only their values. Callers that have the source supply the names in this form. *)

type constant = {
  name : string;  (** the name in the source *)
  unit_ : string;  (** for example [m/s], or [""] *)
  place : Basis.Span.t;  (** the place of its definition *)
}

type t = at:Basis.Span.t -> float -> constant option
(** The named constant that has this value and is written as an operand of the operation at this
    place. [None] if there is no such constant, or if it is unclear which operand is meant. *)

val none : t

val definition : program:string -> Basis.Real.t -> constant -> name:string -> float -> string
(** The constant in C, with its unit and place in a comment. The comment includes the file name only
    if the constant is not in the file of [program]. *)
