(** Messages about fields that a value does not have, with suggestions of what the user may have
    meant. Codes: [E0310] no such field · [E0311] several types have it. *)

open Basis
open Typing

val of_record :
  Wording.t -> Syntax.Ir.name -> record:Resolve.Ir.expr -> Type.t -> string list -> Diagnostic.t
(** The type of [record] does not have the field; the list contains the fields that it has. *)

val of_no_type : Wording.t -> Syntax.Ir.name -> record:Resolve.Ir.expr -> Diagnostic.t
(** No type in scope has the field. *)

val of_several_types : Syntax.Ir.name -> record:Resolve.Ir.expr -> Ir.Global.t list -> Diagnostic.t
(** The type of [record] is unknown, and these types have such a field. *)

val of_argument :
  Wording.t -> at:Span.t -> Syntax.Ir.name -> record:Resolve.Ir.expr -> string -> Diagnostic.t
(** The message for a field that was meant for the result of the named function, as in
    [robotPose i.heading]. *)

val called_as_method : Wording.t -> Application_fact.method_call -> Diagnostic.t -> Diagnostic.t
(** Completes the message about the missing field. *)

val path : Wording.t -> Type.t -> string -> string option
(** The path to the field with this name in a value of the type: the name alone, or [field.name] if
    the field belongs to a nested record. *)
