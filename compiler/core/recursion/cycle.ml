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

(* Shows only the beginning and the last step of a very long cycle. *)
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
    | true, true -> "is defined in terms of itself"
    | true, false -> "is defined in terms of itself through other definitions"
    | false, true -> "calls itself"
    | false, false -> "calls itself through other definitions"
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
          "a task may only restart itself as the last statement of a `do`, after a task that takes \
           time"
        else if List.for_all (fun v -> not (vertex v).function_) cycle then
          "a top-level definition is a constant, not a variable that you can assign to"
        else
          "functions cannot be recursive: use `foldl` or `scanl` to process an array; a signal \
           function may only restart itself in the continuation of a switch")
