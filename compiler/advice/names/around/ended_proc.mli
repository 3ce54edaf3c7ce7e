(** Hints about a name that seems to be the input of a [proc], but is used where that [proc] has
    ended. *)

open Basis

type hint = {
  text : string;
  edits : (Span.t * string) list;  (** the change that the hint describes; may be empty *)
}

val without_name : Syntax.Ir.program -> Syntax.Ir.name -> hint option
(** The hint if the innermost [proc] around the name has [_] as its input. *)

val is_in_second_where : Syntax.Ir.program -> Syntax.Ir.name -> bool
(** Is the name in the [where] of a definition whose body is a [proc] that also has a [where]? *)

val lambda_before_where : Syntax.Ir.program -> Syntax.Ir.name -> (Syntax.Ir.name * Span.t) option
(** For the parameter [i] of a definition [f = \\i -> …] that is used in the [where] of that
    definition: the name [f], and the place of `\\i`. *)

val of_switch : text:string -> Syntax.Ir.program -> Syntax.Ir.name -> hint option
(** If the name is an input of the first argument of a [switch] but is used in another argument: a
    hint to move the event into the first argument, or to carry the value in the event to the next
    mode. [text]: the source text of the module. *)
