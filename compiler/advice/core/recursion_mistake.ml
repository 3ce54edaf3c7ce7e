open Basis
open Core

type vertex = { name : string; span : Span.t; task : bool; function_ : bool }

let rec gives_task : Ir.ty -> bool = function
  | Data ({ module_ = "Prelude"; name = "Task" }, _) -> true
  | Function (_, result) -> gives_task result
  | _ -> false

let is_function : Ir.ty -> bool = function Function _ | Signal_function _ -> true | _ -> false

(* Whether the definition has an [Int] parameter and does not return a signal function. *)
let takes_a_number (d : Ir.definition) =
  let rec result : Ir.ty -> Ir.ty = function Function (_, r) -> result r | t -> t in
  let rec parameters : Ir.ty -> Ir.ty list = function
    | Function (p, r) -> p :: parameters r
    | _ -> []
  in
  let is_number : Ir.ty -> bool = function Int -> true | _ -> false in
  (match result d.ty with Signal_function _ -> false | _ -> true)
  && List.exists is_number (parameters d.ty)

let vertex (d : Ir.definition) =
  { name = d.name.name; span = d.span; task = gives_task d.ty; function_ = is_function d.ty }

(* Maximum number of steps in a message. If the cycle is longer, the message omits steps just before
   the last one. *)
let longest_shown = 12

let shorten steps =
  let n = List.length steps in
  if n <= longest_shown then steps
  else List.filteri (fun i _ -> i < longest_shown - 1 || i = n - 1) steps

let cycle_diagnostic cycle =
  let named v = "`" ^ v.name ^ "`" in
  let vertices = List.map (fun (d, _) -> vertex d) cycle in
  let first = List.hd vertices in
  let steps =
    List.combine (List.map2 (fun v (_, at) -> (v, at)) vertices cycle) (List.tl vertices @ [ first ])
    |> shorten
  in
  let message =
    match (not (first.function_ || first.task), List.length steps = 1) with
    | true, true -> "is defined in terms of itself"
    | true, false -> "is defined in terms of itself through other definitions"
    | false, true -> "calls itself"
    | false, false -> "calls itself through other definitions"
  in
  let path d =
    if List.compare_length_with cycle 1 = 0 then d
    else Diagnostic.here "%s" (Enumeration.circle (List.map (fun v -> v.name) vertices)) d
  in
  List.fold_left
    (fun diagnostic ((a, at), b) ->
      let text = Printf.sprintf "%s uses %s here" (named a) (named b) in
      Diagnostic.label ~at "%s" text diagnostic)
    (Diagnostic.error ~code:"E0410" ~at:first.span "%s %s" (named first) message |> path)
    steps
  |> Diagnostic.note "%s"
       (if List.for_all (fun v -> v.task) vertices then
          "a task may only restart itself as the last statement of a `do`, after a task that takes \
           time"
        else if List.for_all (fun v -> not v.function_) vertices then
          "a top-level definition is a constant, not a variable that you can assign to"
        else
          "functions cannot be recursive: use `foldl` or `scanl` to process an array; a signal \
           function may only restart itself in the continuation of a switch")

let cycle cycle (cause : Fact.cause) =
  let diagnostic = cycle_diagnostic cycle in
  match cause with
  | Itself when List.for_all (fun ((d : Ir.definition), _) -> gives_task d.ty) cycle -> diagnostic
  | Itself when List.for_all (fun (d, _) -> takes_a_number d) cycle ->
      Diagnostic.hint
        "for a loop over 0, 1, … up to `n`, write `foldl (\\s k -> if k <= n then s + k else s) 0 \
         (generate id :: Array 100 Int)`: `s + k` combines the result so far with the number `k`, \
         0 is the initial result, and the array size, here 100, must be greater than `n`"
        diagnostic
  | Itself ->
      Diagnostic.hint
        "for a value that depends on its own past, write an equation with `delay` in a `proc`, as \
         in `n = delay 0 n + 1`"
        diagnostic
  | Methods { default = None } -> diagnostic
  | Methods { default = Some (class_, ty) } ->
      diagnostic
      |> Diagnostic.note
           "this happens for the type `%s`, because its instance of `%s` relies on default methods"
           (Print.type_name ty) class_.name
      |> Diagnostic.hint "define one of the methods in the instance"

let growing_types (d : Ir.definition) at =
  Diagnostic.error ~code:"E0413" ~at "`%s` uses itself at ever larger types" d.name.name
  |> Diagnostic.label ~at:d.span "defined here"

let too_many_types (d : Ir.definition) combinations =
  Diagnostic.error ~code:"E0413" ~at:d.span "`%s` is used at too many types" d.name.name
  |> Diagnostic.note "definitions that use methods are already needed for %d combinations of types"
       combinations
  |> Diagnostic.hint
       "shorten the chain of definitions: if each one uses the next at two new types, every step \
        doubles the number of types"

let larger_type (d : Ir.definition) (use : Fact.use) ty way =
  let label diagnostic ((by : Ir.definition), (use : Fact.use)) =
    Diagnostic.label ~at:use.at "`%s` starts `%s` here" by.name.name use.by.name diagnostic
  in
  let error =
    Diagnostic.error ~code:"E0417" ~at:use.at "`%s` restarts itself at a larger type" use.by.name
    |> Diagnostic.here "here its type variable becomes `%s`" (Print.type_name ty)
  in
  (match way with
  | [] -> Diagnostic.label ~at:d.span "`%s` is defined here" d.name.name error
  | way -> List.fold_left label error way)
  |> Diagnostic.hint "restart it with the same types"

let diagnostic (fact : Fact.t) =
  match fact with
  | Cycle { cycle = steps; cause } -> cycle steps cause
  | Growing_types { definition; at } -> growing_types definition at
  | Too_many_types { definition; combinations } -> too_many_types definition combinations
  | Larger_type { definition; use; ty; way } -> larger_type definition use ty way
