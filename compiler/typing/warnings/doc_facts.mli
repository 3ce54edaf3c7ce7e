(** Reads facts about functions and records from their doc comments, for warnings.

    The library itself states these facts, so the compiler does not need a list that could become
    outdated. Programs can state such facts, too. Three kinds of sentences are recognized:

    - [Requires: `tau >= 0`, `low <= high`.] Conditions on parameters, or on fields of a record. A
      condition compares a parameter, or the [sum] of an array, with a number in base units or with
      another parameter, using [>=], [>], [<=] or [/=]. The names of the parameters are those in the
      first words of the comment, [`lowPass tau`], or else those in the definition.
    - [For angles that wrap, use `lowPassAngle` (module Angles).] The function is not suitable for
      angles that jump from pi to -pi. The other function takes the same arguments; if the sentence
      says [see] instead of [use], it takes different ones. If the sentence names [unwrap], apply
      [unwrap] to the angle.
    - A result that [wraps at pi] is such an angle. *)

type t

val of_program : Resolve.Ir.program -> t

type term = Number of float | Parameter of int  (** position, from 0 *) | Sum of int
type relation = At_least | Above | At_most | Differs
type requirement = { left : term; relation : relation; right : term }

val requirements : t -> Resolve.Ir.Global.t -> requirement list
(** The requirements of a function, or of a record's constructor, whose parameters are the fields.
*)

type for_angles = { name : string; module_ : string; same_arguments : bool }

val for_angles : t -> Resolve.Ir.Global.t -> for_angles option
val wraps : t -> Resolve.Ir.Global.t -> bool
