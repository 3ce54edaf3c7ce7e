(** Hints about a name that seems to be the input of a [proc], but is used where that [proc] has
    ended. *)

open Basis

type hint = {
  text : string;
  edits : (Span.t * string) list;  (** the change that the hint describes; may be empty *)
}

val without_name : Syntax.Ir.program -> Syntax.Ir.name -> hint option
(** The hint if the innermost [proc] around the name has [_] in place of an input. *)

val is_in_second_where : Syntax.Ir.program -> Syntax.Ir.name -> bool
(** Is the name in the [where] of a definition whose body is a [proc] that also has a [where]? *)

val lambda_before_where : Syntax.Ir.program -> Syntax.Ir.name -> (Syntax.Ir.name * Span.t) option
(** The defined name and the place of `\\i`, if the name is the parameter of the anonymous function
    that a definition consists of, and is used in its [where]. *)

val of_switch : text:string -> Syntax.Ir.program -> Syntax.Ir.name -> hint option
(** If the name is an input of the first argument of a [switch] but is used in another argument, a
    hint that shows how to pass it on, either as a separate argument for the event or to the next
    mode. [text]: the source text of the module. *)
