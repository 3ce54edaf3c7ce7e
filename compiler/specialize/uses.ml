module Ir = Core.Ir

type target =
  | Definition of Ir.Global.t * Ir.ty list
  | Method of { class_ : Ir.Global.t; name : string; ty : Ir.ty; types : Ir.ty list }

let of_expr ~continuations e =
  let rec uses found (e : Ir.expr) =
    match e.desc with
    | Global (g, types) -> (Definition (g, types), e.span) :: found
    | Method { class_; name; ty; types } -> (Method { class_; name; ty; types }, e.span) :: found
    | Local _ | Primitive _ | Number _ | Boolean _ | String _ -> found
    | Lambda (_, e) | Component (e, _) | Index (e, _) | Is_constructor (e, _) | Payload { value = e; _ } ->
        uses found e
    | Apply (f, argument) when (not continuations) && Cycle.is_continuation argument.ty ->
        uses found f
    | Apply (a, b) -> uses (uses found a) b
    | Let { value; body; binder = _ } -> uses (uses found value) body
    | Tuple es | Array es | Construct { arguments = es; _ } -> List.fold_left uses found es
    | If (a, b, c) -> uses (uses (uses found a) b) c
    | Proc p ->
        let right found (eq : Ir.equation) =
          match eq.rhs with
          | Pure e -> uses found e
          | Run { signal_function; input } -> uses (uses found signal_function) input
        in
        uses (List.fold_left right found p.equations) p.output
  in
  List.rev (uses [] e)
