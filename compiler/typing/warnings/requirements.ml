open Basis
open Ir

type walk = { sink : Diagnostic.sink; constants : Constant.t; facts : Doc_facts.t }

let number w e =
  match Constant.value w.constants e with
  | Some (Float x) -> Some x
  | Some (Int n) -> Some (float_of_int n)
  | None -> None

let is_time (e : expr) =
  match e.ty with
  | Number (_, { base = [ ({ module_ = "Prelude"; name = "s" }, power) ]; variables = [] }) ->
      power = { Syntax.Ir.numerator = 1; denominator = 1 }
  | _ -> false

let negative_time w ~of_ (e : expr) =
  Diagnostic.(
    warning ~code:"W0309" ~at:e.span "`%s` has a negative time, which counts as zero" of_
    |> hint "write a time of at least `0[s]`"
    |> emit w.sink)

let swapped w ~of_ (low : expr) (high : expr) =
  Diagnostic.(
    warning ~code:"W0316" ~at:low.span "the lower limit of `%s` is above the upper one" of_
    |> label ~at:high.span "the upper limit"
    |> hint "swap them" |> emit w.sink)

let negative w ~of_ (e : expr) =
  Diagnostic.(
    warning ~code:"W0316" ~at:e.span "this is below zero: `%s` needs a number of at least 0" of_
    |> hint "leave the sign out" |> emit w.sink)

let out_of_range w ~of_ (e : expr) what range x =
  Diagnostic.(
    warning ~code:"W0316" ~at:e.span "this is too %s: `%s` needs a number %s %g" what of_ range x
    |> emit w.sink)

let no_sum w ~of_ (e : expr) =
  Diagnostic.(
    warning ~code:"W0316" ~at:e.span "these numbers add up to 0: `%s` needs another sum" of_
    |> emit w.sink)

(* The sum of an array of constants. *)
let sum w (e : expr) =
  let add total x =
    match (total, number w x) with Some total, Some x -> Some (total +. x) | _ -> None
  in
  match e.desc with Array es -> List.fold_left add (Some 0.) es | _ -> None

(* [name k]: the name of parameter k by itself. [of_]: the name of the whole function or record. *)
let check w ~of_ ~name ~argument (r : Doc_facts.requirement) =
  let value (t : Doc_facts.term) =
    match t with
    | Number x -> Some x
    | Parameter k -> Option.bind (argument k) (number w)
    | Sum k -> Option.bind (argument k) (sum w)
  in
  let is_violated a b =
    match r.relation with
    | At_least -> a < b
    | Above -> a <= b
    | At_most -> a > b
    | Differs -> a = b
  in
  let report () =
    let at k ~report = Option.iter report (argument k) in
    match (r.left, r.relation, r.right) with
    | Parameter k, At_least, Number 0. ->
        at k ~report:(fun e ->
            if is_time e then negative_time w ~of_:(name k) e else negative w ~of_:(name k) e)
    | Parameter k, At_least, Number x ->
        at k ~report:(fun e -> out_of_range w ~of_:(name k) e "small" "of at least" x)
    | Parameter k, Above, Number x ->
        at k ~report:(fun e -> out_of_range w ~of_:(name k) e "small" "above" x)
    | Parameter k, At_most, Number x ->
        at k ~report:(fun e -> out_of_range w ~of_:(name k) e "large" "of at most" x)
    | Parameter low, At_most, Parameter high -> (
        match (argument low, argument high) with
        | Some low, Some high -> swapped w ~of_ low high
        | _ -> ())
    | Sum k, Differs, Number _ -> at k ~report:(no_sum w ~of_:(name k))
    | _ -> ()
  in
  match (value r.left, value r.right) with
  | Some a, Some b when is_violated a b -> report ()
  | _ -> ()

let fields w (c : constructor) given =
  let name k = match List.nth_opt c.fields k with Some (name, _) -> name | None -> "" in
  let argument k = List.assoc_opt k given in
  List.iter
    (check w ~of_:c.constructor.name ~name ~argument)
    (Doc_facts.requirements w.facts c.constructor)

let rec expr w (e : expr) =
  (match e.desc with
  | Record (c, given) | Update (_, c, given) -> fields w c given
  | _ -> (
      match Constant.spine e with
      | { desc = Global (g, _) | Primitive (g, _); _ }, (_ :: _ as arguments) ->
          List.iter
            (check w ~of_:g.name ~name:(fun _ -> g.name) ~argument:(List.nth_opt arguments))
            (Doc_facts.requirements w.facts g)
      | _ -> ()));
  Walk.parts (expr w) e

let warn sink resolved program =
  let w =
    { sink; constants = Constant.of_program program; facts = Doc_facts.of_program resolved }
  in
  Walk.own resolved (expr w) program
