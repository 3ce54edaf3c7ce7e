(** Messages about qualified names that do not exist, and about names that a module does not define.
*)

open Basis

val unknown_qualifier :
  Suggestion.t -> Resolve.Visible.t -> Syntax.Ir.name -> Syntax.Ir.name -> Diagnostic.t
(** Takes the qualifier and the name after it. *)

val unknown_in_module :
  Suggestion.t ->
  Resolve.Interface.namespace ->
  qualifier:Syntax.Ir.name ->
  known:string list Lazy.t ->
  Syntax.Ir.name ->
  Diagnostic.t

val absent :
  Suggestion.t ->
  module_:string ->
  known:string list Lazy.t ->
  to_:string ->
  Syntax.Ir.name ->
  Diagnostic.t
(** Reports a name that an export or import list contains but the module does not define. [to_]: the
    purpose of the list, [export] or [import]. *)
