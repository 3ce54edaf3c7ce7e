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

(* `max 1 (min (-1) x)` is always 1, and `min (-1) (max 1 x)` always -1. *)
let limits w (e : expr) =
  let known (e : expr) = Option.map (fun x -> (x, e)) (number w e) in
  let operands name e =
    match Constant.operation e with
    | Some (other, [ a; b ]) when String.equal name other -> (
        match (known a, known b) with
        | Some a, None -> Some (a, b)
        | None, Some b -> Some (b, a)
        | _ -> None)
    | _ -> None
  in
  let check outer inner ~is_outside =
    match operands outer e with
    | Some ((limit, at), inside) -> (
        match operands inner inside with
        | Some ((other, other_at), _) when is_outside limit other ->
            Diagnostic.(
              warning ~code:"W0316" ~at:at.span
                "the lower limit is above the upper one, so the result is always this limit"
              |> label ~at:other_at.span "the other limit"
              |> hint "swap the two limits" |> emit w.sink)
        | _ -> ())
    | None -> ()
  in
  check "max" "min" ~is_outside:(fun low high -> low > high);
  check "min" "max" ~is_outside:(fun high low -> high < low)

(* `clamp x 0 1` limits the constant 1. *)
let limited_constant w (name : Resolve.Ir.Global.t) arguments =
  match (name.name, name.module_, arguments) with
  | "clamp", "Control", [ low; high; y ] -> (
      match (number w low, number w high, number w y) with
      | None, Some high_, Some x when high_ <= x ->
          Diagnostic.(
            warning ~code:"W0316" ~at:low.span
              "this is the lower limit of `clamp`, and the value that it limits is a constant"
            |> label ~at:(y : expr).span "the limited value"
            |> label ~at:(high : expr).span "the upper limit"
            |> hint "write the limits first: `clamp low high x`"
            |> emit w.sink)
      | _ -> ())
  | _ -> ()

let rec expr w (e : expr) =
  limits w e;
  (match e.desc with
  | Record (c, given) | Update (_, c, given) -> fields w c given
  | _ -> (
      match Constant.spine e with
      | { desc = Global (g, _) | Primitive (g, _); _ }, (_ :: _ as arguments) ->
          limited_constant w g arguments;
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
