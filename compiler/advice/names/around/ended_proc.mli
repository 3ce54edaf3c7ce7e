(** Hints about a name that seems to be the input of a [proc], but is used after the end of that
    [proc]. *)

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
(** If the name is the parameter [i] of a definition [f = \\i -> …] but is used in the [where] of
    that definition: the name [f], and the place of `\\i`. *)

val of_switch : text:string -> Syntax.Ir.program -> Syntax.Ir.name -> hint option
(** If the first argument of a [switch] binds the name as its input, but another argument uses it: a
    hint to move the event into the first argument, or to let the event carry the value to the next
    mode. [text]: the source text of the module. *)
