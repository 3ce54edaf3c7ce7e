open Ir

let make ty span desc = { desc; ty; span }
let variable (binder : binder) span = make binder.ty span (Local binder.local)
let boolean b span = make Bool span (Boolean b)
let apply f a ty span = make ty span (Apply (f, a))

let not_ (e : expr) =
  match e.desc with
  | If (a, { desc = Boolean false; _ }, { desc = Boolean true; _ }) -> a
  | Boolean b -> boolean (not b) e.span
  | _ -> make Bool e.span (If (e, boolean false e.span, boolean true e.span))

let conjunction (a : expr) b = make Bool a.span (If (a, b, boolean false a.span))

let if_ (condition : expr) (then_ : expr) else_ span =
  match condition.desc with
  | If (a, { desc = Boolean false; _ }, { desc = Boolean true; _ }) ->
      make then_.ty span (If (a, else_, then_))
  | _ -> make then_.ty span (If (condition, then_, else_))

let equal (a : expr) (b : expr) =
  let partial = Function (a.ty, Bool) in
  let equal = make (Function (a.ty, partial)) a.span (Primitive (Primitive.Equal, [ a.ty ])) in
  apply (apply equal a partial a.span) b Bool a.span

let let_ binder value (body : expr) = make body.ty body.span (Let { binder; value; body })

let rec is_trivial (e : expr) =
  match e.desc with
  | Local _ | Global _ | Primitive _ | Method _ | Number _ | Boolean _ | String _ | Tuple [] -> true
  | Apply (f, { desc = Tuple []; _ }) -> is_trivial f
  | Construct { arguments = []; _ } -> true
  | Construct _ | Lambda _ | Apply _ | Let _ | Tuple _ | Array _ | Index _ | Component _
  | Is_constructor _ | Payload _ | If _ | Proc _ ->
      false

let parts (e : expr) =
  match e.desc with
  | Local _ | Global _ | Primitive _ | Method _ | Number _ | Boolean _ | String _ -> []
  | Lambda (_, e)
  | Component (e, _)
  | Index (e, _)
  | Is_constructor (e, _)
  | Payload { value = e; _ } ->
      [ e ]
  | Apply (f, argument) -> [ f; argument ]
  | Let { value; body; binder = _ } -> [ value; body ]
  | Tuple es | Array es | Construct { arguments = es; _ } -> es
  | If (a, b, c) -> [ a; b; c ]
  | Proc { equations; output; input = _ } ->
      let right (eq : equation) =
        match eq.rhs with
        | Pure e -> [ e ]
        | Run { signal_function; input } -> [ signal_function; input ]
      in
      List.concat_map right equations @ [ output ]

let rec visit f e =
  f e;
  List.iter (visit f) (parts e)

let with_parts f (e : expr) =
  let right = function
    | Pure e -> Pure (f e)
    | Run { signal_function; input } ->
        let signal_function = f signal_function in
        Run { signal_function; input = f input }
  in
  match e.desc with
  | Local _ | Global _ | Primitive _ | Method _ | Number _ | Boolean _ | String _ -> e.desc
  | Lambda (b, body) -> Lambda (b, f body)
  | Component (value, k) -> Component (f value, k)
  | Index (array, k) -> Index (f array, k)
  | Is_constructor (value, k) -> Is_constructor (f value, k)
  | Payload p -> Payload { p with value = f p.value }
  | Apply (g, argument) ->
      let g = f g in
      Apply (g, f argument)
  | Let { binder; value; body } ->
      let value = f value in
      Let { binder; value; body = f body }
  | Tuple es -> Tuple (Basis.Long_list.map f es)
  | Array es -> Array (Basis.Long_list.map f es)
  | Construct c -> Construct { c with arguments = Basis.Long_list.map f c.arguments }
  | If (a, b, c) ->
      let a = f a in
      let b = f b in
      If (a, b, f c)
  | Proc p ->
      let equation (eq : equation) = { eq with rhs = right eq.rhs } in
      let equations = Basis.Long_list.map equation p.equations in
      Proc { p with equations; output = f p.output }
