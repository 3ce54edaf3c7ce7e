open Basis
open Ir

type walk = { facts : Fact.t Facts.t; constants : Constant.t; docs : Doc_facts.t }

let report w fact = Facts.report w.facts (Warning fact)

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

(* The sum of an array of constants. *)
let sum w (e : expr) =
  let add total x =
    match (total, number w x) with Some total, Some x -> Some (total +. x) | _ -> None
  in
  match e.desc with Array es -> List.fold_left add (Some 0.) es | _ -> None

(* [name k]: the name of parameter k. [of_]: the name of the function or record. *)
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
  let unmet k unmet =
    Option.iter (fun argument -> report w (Unmet { of_ = name k; argument; unmet })) (argument k)
  in
  let report () =
    match (r.left, r.relation, r.right) with
    | Parameter k, At_least, Number 0. ->
        let is_time = Option.fold (argument k) ~none:false ~some:is_time in
        unmet k (if is_time then Negative_time else Negative)
    | Parameter k, At_least, Number x -> unmet k (Below x)
    | Parameter k, Above, Number x -> unmet k (Not_above x)
    | Parameter k, At_most, Number x -> unmet k (Above x)
    | Parameter low, At_most, Parameter high -> (
        match (argument low, argument high) with
        | Some low, Some high -> report w (Swapped_limits { of_; low; high })
        | _ -> ())
    | Sum k, Differs, Number _ -> unmet k Zero_sum
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
    (Doc_facts.requirements w.docs c.constructor)

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
            report w (Limits_cross { limit = at; other = other_at })
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
          report w (Limited_constant { low; high; limited = y })
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
            (Doc_facts.requirements w.docs g)
      | _ -> ()));
  Walk.parts (expr w) e

let warn facts resolved program =
  let w =
    { facts; constants = Constant.of_program program; docs = Doc_facts.of_program resolved }
  in
  Walk.own resolved (expr w) program
