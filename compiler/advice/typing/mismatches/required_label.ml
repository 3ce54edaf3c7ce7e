open Basis
open Typing
open Instance_fact

let text_of_cause words = function
  | Signature { name; class_; parameter } ->
      Printf.sprintf "`%s` requires `%s` here" name (Wording.constraint_ words class_ parameter)
  | Superclass { class_; of_ } ->
      Printf.sprintf "`%s` is a superclass of `%s`" (Show.class_ class_) of_.name

let add words required diagnostic =
  match required.because with
  | Some (place, cause) -> Diagnostic.label ~at:place "%s" (text_of_cause words cause) diagnostic
  | None -> diagnostic

let user words required =
  match required.by with
  | Name name -> Printf.sprintf "`%s`" name
  | Instance (class_, head) -> Printf.sprintf "`%s`" (Wording.constraint_ words class_ head)
