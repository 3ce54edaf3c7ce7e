open Basis
open Typing
open Diagnostic

(* The name `x` if the expression is its previous value: `delay 0 x` or `previous x`. *)
let previous (e : Resolve.Ir.expr) =
  match Resolve.Walk.application e with
  | { desc = Global { name = "delay"; _ }; _ }, [ _; { desc = Local x; _ } ]
  | { desc = Global { name = "previous"; _ }; _ }, [ { desc = Local x; _ } ] ->
      Some x
  | _ -> None

(* For the sum of a name's previous value and another operand: the name and that operand. *)
let parts (a : Resolve.Ir.expr) (b : Resolve.Ir.expr) =
  match (previous a, previous b) with
  | Some x, None -> Some (x, b)
  | None, Some x -> Some (x, a)
  | _ -> None

(* The text of the product without its numbers. *)
let rate words (e : Resolve.Ir.expr) =
  let is_number (e, _) = Bare_number.literal words e <> None in
  match List.filter (fun factor -> not (is_number factor)) (Formula.factors e) with
  | [ (x, 1) ] -> Formula.grouped words x
  | all when all <> [] && List.for_all (fun (_, power) -> power = 1) all ->
      let texts = List.map (fun (x, _) -> Formula.as_factor words x) all in
      Option.map (fun texts -> Source.grouped (String.concat " * " texts)) (Shape_fact.all texts)
  | _ -> None

let complete words ~subject ~(expected : Expected.t) (wanted, given) =
  let seconds u = String.equal (Wording.measure words u) "s" in
  let differ_by_time =
    (not (Units.is_open wanted || Units.is_open given))
    && (seconds (Units.divide wanted given) || seconds (Units.divide given wanted))
  in
  let defined (e : Resolve.Ir.expr) =
    match e.desc with
    | Local x ->
        Option.bind (Wording.definition words x) (fun definition ->
            match Formula.binary definition with
            | Some ("+", a, b) -> (
                match parts a b with
                | Some (y, rate) when String.equal x.name y.name -> Some (y, rate)
                | Some _ | None -> None)
            | Some _ | None -> None)
    | _ -> None
  in
  let found =
    match (expected.because, subject) with
    | Operand { operator = "+"; other; _ }, Some e when parts other e <> None -> parts other e
    | Operand { other; _ }, Some e -> (
        match defined e with Some it -> Some it | None -> defined other)
    | _, Some e -> defined e
    | _, None -> None
  in
  match found with
  | Some ((x : Resolve.Ir.Local.t), change) when differ_by_time ->
      Option.map
        (fun text d ->
          label ~at:change.span "this is added to `%s` at every instant" x.name d
          |> hint
               "for the sum over time, write `%s = integral %s`, which accounts for the time \
                between two instants"
               x.name text)
        (rate words change)
  | Some _ | None -> None
