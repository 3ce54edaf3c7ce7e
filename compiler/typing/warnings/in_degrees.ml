(* A product: its constant factor, and the source expressions of the other factors. *)
type product = { number : float; others : Resolve.Ir.expr list }

let degree = Float.pi /. 180.

let is_degree (u : Resolve.Ir.unit_) =
  match u.factors with
  | [ (Declared { module_ = "Prelude"; name = "deg" }, _) ] -> true
  | _ -> false

let mentions_degrees (u : Resolve.Ir.unit_) =
  List.exists
    (function Resolve.Ir.Declared { module_ = "Prelude"; name = "deg" }, _ -> true | _ -> false)
    u.factors

let is_angular t =
  Degrees.is_angle t
  ||
  match Type.repr t with
  | Alias { alias = { module_ = "Prelude"; name = "AngularVelocity" }; _ } -> true
  | _ -> false

let definition ctx (e : Resolve.Ir.expr) =
  match e.desc with Local x -> (Context.surroundings ctx).definition x | _ -> None

(* [depth]: the maximum number of definitions to follow. *)
let rec product ctx depth (e : Resolve.Ir.expr) =
  let plain = { number = 1.; others = [ e ] } in
  match (e.desc, Degrees.operation e) with
  | Number { digits; unit_; _ }, _ -> (
      match (float_of_string_opt digits, unit_) with
      | Some number, None -> { number; others = [] }
      | Some number, Some u when is_degree u -> { number = number *. degree; others = [] }
      | _ -> plain)
  | Global { module_ = "Prelude"; name = "pi" }, _ -> { number = Float.pi; others = [] }
  | Negate operand, _ ->
      let p = product ctx depth operand in
      { p with number = -.p.number }
  | _, Some (left, "*", right) ->
      let a = product ctx depth left and b = product ctx depth right in
      { number = a.number *. b.number; others = a.others @ b.others }
  | _, Some (left, "/", right) -> (
      match product ctx depth right with
      | { number; others = [] } ->
          let a = product ctx depth left in
          { a with number = a.number /. number }
      | _ -> plain)
  | Local _, _ when depth > 0 -> (
      match Option.map (product ctx (depth - 1)) (definition ctx e) with
      | Some ({ number; _ } as p) when number <> 1. -> p
      | _ -> plain)
  | _ -> plain

let names_behind = 3

(* The factors that a product converts to degrees. Its constant factor may be an approximation of
   180/π, such as 57.3 or 180/3.14. *)
let in_degrees ctx e =
  match product ctx names_behind e with
  | { others = _ :: _ as others; number } when Float.abs ((number *. degree) -. 1.) < 0.001 ->
      Some others
  | _ -> None

let rec has_degree ctx (e : Resolve.Ir.expr) =
  match (e.desc, Degrees.operation e) with
  | Number { unit_ = Some u; _ }, _ -> mentions_degrees u
  | Negate operand, _ -> has_degree ctx operand
  | _, Some (left, ("*" | "/" | "+" | "-"), right) -> has_degree ctx left || has_degree ctx right
  | Local _, _ -> (
      match definition ctx e with
      | Some { desc = Number { unit_ = Some u; _ }; _ } -> mentions_degrees u
      | _ -> false)
  | _ -> false

let report ctx ?beside angle factors = Context.warn ctx (In_degrees { angle; factors; beside })

let warn ctx e (expected : Expected.t) =
  if is_angular expected.ty then Option.iter (report ctx e) (in_degrees ctx e)

let meets operator = Degrees.compares operator || List.mem operator [ "+"; "-" ]

let warn_of_operands ctx (left, left_type) (right, right_type) =
  let is_radians e ty = is_angular ty || has_degree ctx e in
  match (in_degrees ctx left, in_degrees ctx right) with
  | Some others, None when is_radians right right_type -> report ctx ~beside:right left others
  | None, Some others when is_radians left left_type -> report ctx ~beside:left right others
  | _ -> ()
