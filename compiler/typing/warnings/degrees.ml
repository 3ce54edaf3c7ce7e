let is_angle t =
  match Type.repr t with
  | Alias { alias = { module_ = "Prelude"; name = "Angle" }; _ } -> true
  | _ -> false

let turn = 2. *. Float.pi

let operation (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply
      {
        head =
          { desc = Apply { head = { desc = Global g; _ }; argument = left; style = Operator _ }; _ };
        argument = right;
        style = Operator _;
      }
    when String.equal g.module_ "Prelude" ->
      Some (left, g.name, right)
  | _ -> None

(* The value of a unitless number, or of a product or quotient of such numbers. *)
let rec constant (e : Resolve.Ir.expr) =
  match (e.desc, operation e) with
  | Number { unit_ = None; digits; _ }, _ -> float_of_string_opt digits
  | Negate operand, _ -> Option.map Float.neg (constant operand)
  | _, Some (left, "*", right) -> both ( *. ) left right
  | _, Some (left, "/", right) -> both ( /. ) left right
  | _ -> None

and both compute left right =
  match (constant left, constant right) with Some a, Some b -> Some (compute a b) | _, _ -> None

let rec warn_of_angle ctx (e : Resolve.Ir.expr) =
  match (constant e, operation e) with
  | Some value, _ -> if Float.abs value > turn then Context.warn ctx (Over_a_turn e)
  | None, Some (left, ("+" | "-"), right) ->
      warn_of_angle ctx left;
      warn_of_angle ctx right
  | None, _ -> ()

let warn ctx e (expected : Expected.t) = if is_angle expected.ty then warn_of_angle ctx e
let compares = function "==" | "/=" | "<" | "<=" | ">" | ">=" -> true | _ -> false

let warn_of_operands ctx (left, left_type) (right, right_type) =
  if is_angle left_type then warn_of_angle ctx right;
  if is_angle right_type then warn_of_angle ctx left

let keeps (head : Resolve.Ir.expr) =
  match head.desc with
  | Global { module_ = "Prelude"; name = "abs" | "negate" | "min" | "max" | "+" | "-" } -> true
  | Global { module_ = "Control"; name } ->
      List.mem name [ "limit"; "clamp"; "deadband"; "previous"; "lowPass" ]
  | _ -> false

let kept (result : Type.t) ~operand =
  match Type.repr result with Number _ when is_angle operand -> operand | _ -> result
