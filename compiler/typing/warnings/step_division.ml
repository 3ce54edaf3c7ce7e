open Basis
open Ir

let is_step_time (e : expr) =
  match e.desc with
  | Run ({ desc = Primitive (g, _); _ }, _) ->
      String.equal g.module_ "Control" && String.equal g.name "stepTime"
  | _ -> false

(* Is the expression 0 if the step is 0? True for the step, a product with it, or a fraction of it.
   *)
let rec is_step steps (e : expr) =
  is_step_time e
  ||
  match (e.desc, Constant.operation e) with
  | Local (x, _), _ -> List.exists (fun (y : Local.t) -> x.id = y.id) steps
  | _, Some ("*", [ a; b ]) -> is_step steps a || is_step steps b
  | _, Some ("/", [ a; _ ]) -> is_step steps a
  | _, _ -> false

let rec expr facts steps (e : expr) =
  (match Constant.operation e with
  | Some ("/", [ _; b ]) when is_step steps b -> Facts.report facts (Fact.Warning (Step_division e))
  | Some _ | None -> ());
  match e.desc with
  | If (condition, _, _) -> expr facts steps condition
  | Case (scrutinee, _) -> expr facts steps scrutinee
  | Guards _ -> ()
  | Let (bindings, _) | Proc { equations = bindings; _ } ->
      let step (b : binding) =
        match b.pattern.desc with Bound x when is_step steps b.value -> Some x | _ -> None
      in
      Walk.parts (expr facts (List.filter_map step bindings @ steps)) e
  | _ -> Walk.parts (expr facts steps) e

let warn facts resolved program = Walk.own resolved (expr facts []) program
