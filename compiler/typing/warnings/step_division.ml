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

let rec expr out steps (e : expr) =
  (match Constant.operation e with
  | Some ("/", [ _; b ]) when is_step steps b ->
      Diagnostic.(
        warning ~code:"W0314" ~at:e.span
          "this divides by the length of the step, which is 0 at the first instant"
        |> note "there the quotient is infinite, or NaN if the dividend is 0 too"
        |> hint
             "for the slope of a signal, use `derivative`; otherwise divide only in a branch where \
              the step is longer than 0"
        |> emit out)
  | Some _ | None -> ());
  match e.desc with
  | If (condition, _, _) -> expr out steps condition
  | Case (scrutinee, _) -> expr out steps scrutinee
  | Guards _ -> ()
  | Let (bindings, _) | Proc { equations = bindings; _ } ->
      let step (b : binding) =
        match b.pattern.desc with Bound x when is_step steps b.value -> Some x | _ -> None
      in
      Walk.parts (expr out (List.filter_map step bindings @ steps)) e
  | _ -> Walk.parts (expr out steps) e

let warn sink resolved program = Walk.own resolved (expr sink []) program
