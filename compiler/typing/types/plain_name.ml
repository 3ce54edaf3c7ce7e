let of_expr (e : Resolve.Ir.expr) =
  match e.desc with
  | Local { name; _ } | Global { name; _ } | Constructor { name; _ } -> Some name
  | Number _ | String _ | Tuple _ | Array _ | Apply _ | Negate _ | Power _ | If _ | Case _ | Let _
  | Lambda _ | Proc _ | Sequence _ | Record _ | Update _ | Field _ | Annotated _ ->
      None

let rec of_head (e : Resolve.Ir.expr) =
  match e.desc with Apply { head; style = Juxtaposed; _ } -> of_head head | _ -> of_expr e
