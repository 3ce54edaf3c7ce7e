open Basis

let outside ~at ~index ~size =
  Diagnostic.error ~code:"E0418" ~at "index %d is out of range for an array of %d element%s" index
    size
    (if size = 1 then "" else "s")
  |> Diagnostic.note "%s"
       (if size = 1 then "its only element has index 0"
        else Printf.sprintf "the indices are 0 to %d" (size - 1))

let stored ~at ty by =
  let ty = Core.Print.type_name ty in
  (match by with
  | Some (name, place) ->
      Diagnostic.error ~code:"E0412" ~at:place "`%s` cannot keep a value of type `%s`" name ty
      |> Diagnostic.label ~at "this `delay` would store it"
  | None ->
      Diagnostic.error ~code:"E0412" ~at "a value of type `%s` cannot be stored in a `delay`" ty)
  |> Diagnostic.note "functions, signal functions and labels only exist at compile time"

let diagnostic (fact : Specialize.Fact.t) =
  match fact with
  | Recursion fact -> Recursion_mistake.diagnostic fact
  | Limit fact -> Limit_mistake.diagnostic fact
  | Restart fact -> Restart_mistake.diagnostic fact
  | Control fact -> Control_mistake.diagnostic fact
  | Entry fact -> Entry_mistake.diagnostic fact
  | Foreign_name fact -> Foreign_mistake.name fact
  | Outside { at; calls; index; size } -> outside ~at ~index ~size |> Shown_calls.label calls
  | Stored { at; calls; ty; by } -> stored ~at ty by |> Shown_calls.label calls
  | Of_the_instant { at; calls; ty } ->
      Foreign_mistake.of_the_instant ~at ty |> Shown_calls.label calls

let into sink = Facts.into sink diagnostic
