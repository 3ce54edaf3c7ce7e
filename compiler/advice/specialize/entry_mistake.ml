open Basis
open Specialize

(* Does the printed type contain [String]? *)
let has_a_label text =
  let is_letter = function
    | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' | '.' -> true
    | _ -> false
  in
  String.map (fun c -> if is_letter c then c else ' ') text
  |> String.split_on_char ' ' |> List.mem "String"

let interface (definition : Core.Ir.definition) (part : Entry_fact.part) ty =
  let what = match part with Input -> "input" | Output -> "output" | Result -> "result" in
  let ty = Core.Print.type_name ty in
  Diagnostic.(
    error ~code:"E0412" ~at:definition.span "the %s of `%s` cannot be of type `%s`" what
      definition.name.name ty
    |> note "functions, signal functions and labels only exist at compile time"
    |>
    if has_a_label ty then
      hint "to show names, declare a `data` type: `data State = Ready | Stopped`"
    else Fun.id)

let different_results (definition : Core.Ir.definition) =
  Diagnostic.(
    error ~code:"E0411" ~at:definition.span
      "`%s` cannot run: it chooses between programs whose results have different types"
      definition.name.name
    |> hint "choose between tasks inside one `reactimateTask`")

let needs_itself (local : Core.Ir.Local.t) =
  Diagnostic.(
    error ~code:"E0414" ~at:local.span "`%s` contains a function that depends on itself" local.name
    |> note "functions, signal functions and tasks are evaluated at compile time"
    |> hint "feed back the numbers that the function depends on, not the function")

let rate ~at ~slowest ~fastest rate =
  (match rate with
  | Some rate ->
      Diagnostic.error ~code:"E0508" ~at
        "the rate of a node must be between %g and %g Hz, not %g Hz" slowest fastest rate
  | None -> Diagnostic.error ~code:"E0508" ~at "the rate of a node must be known at compile time")
  |> Diagnostic.hint "write a rate such as `50[Hz]`"

let diagnostic (fact : Entry_fact.t) =
  match fact with
  | Interface { definition; part; ty } -> interface definition part ty
  | Different_results definition -> different_results definition
  | Needs_itself local -> needs_itself local
  | Rate { at; rate = given; slowest; fastest } -> rate ~at ~slowest ~fastest given
