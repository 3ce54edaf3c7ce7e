open Basis

type vertex = { name : string; span : Span.t; task : bool; function_ : bool }

let rec gives_task : Ir.ty -> bool = function
  | Data ({ module_ = "Prelude"; name = "Task" }, _) -> true
  | Function (_, result) -> gives_task result
  | _ -> false

let is_function : Ir.ty -> bool = function Function _ | Signal_function _ -> true | _ -> false

let vertex (d : Ir.definition) =
  { name = d.name.name; span = d.span; task = gives_task d.ty; function_ = is_function d.ty }

let steps ~first cycle = List.combine cycle (List.tl cycle @ [ first ])

(* Of a cycle too long to read, the beginning and the last step. *)
let longest_shown = 12

let shorten steps =
  let n = List.length steps in
  if n <= longest_shown then steps
  else List.filteri (fun i _ -> i < longest_shown - 1 || i = n - 1) steps

let diagnostic ~vertex ~use cycle =
  let named v = "`" ^ (vertex v).name ^ "`" in
  let first =
    match cycle with
    | first :: _ -> first
    | [] -> Diagnostic.bug ~stage:"Specialize.Cycle" "an empty cycle"
  in
  let steps = shorten (steps ~first cycle) in
  let is_value = not (vertex first).function_ in
  let message =
    match (is_value && not (vertex first).task, List.length steps = 1) with
    | true, true -> "is made of itself"
    | true, false -> "is made of itself through others"
    | false, true -> "calls itself"
    | false, false -> "calls itself through others"
  in
  let path d =
    if List.compare_length_with cycle 1 = 0 then d
    else Diagnostic.here (Enumeration.circle (List.map (fun v -> (vertex v).name) cycle)) d
  in
  List.fold_left
    (fun diagnostic (a, b) ->
      let text = Printf.sprintf "%s uses %s here" (named a) (named b) in
      Diagnostic.label ~at:(use a b) text diagnostic)
    (Diagnostic.error ~code:"E0410" ~at:(vertex first).span "%s %s" (named first) message |> path)
    steps
  |> Diagnostic.note
       (if List.for_all (fun v -> (vertex v).task) cycle then
          "a task may start itself again only as the last statement of a `do`, after something \
           that takes time"
        else if List.for_all (fun v -> not (vertex v).function_) cycle then
          "nothing is assigned: a definition at the top level has one value, always the same"
        else
          "functions may not be recursive, but `foldl` and `scanl` go through arrays; a signal \
           function may start itself again only in the continuation of a switch")
