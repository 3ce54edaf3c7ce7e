open Context

let bind ctx (local : Ir.Local.t) (expected : Expected.t) =
  match find_local ctx local with
  | Some declared ->
      expect ctx ~at:local.span
        {
          ty = declared.body;
          because = Signature { name = local.name; at = local.span };
          parts = [];
        }
        expected.ty
  | None -> bind_local ctx local (Type.monomorphic expected.ty)

let rec check ctx (p : Resolve.Ir.pattern) (expected : Expected.t) : Ir.pattern later =
  let node desc () : Ir.pattern =
    let desc = desc () in
    { desc; ty = Final.ty expected.ty; span = p.span }
  in
  match p.desc with
  | Any -> node (fun () -> Any)
  | Bound local ->
      bind ctx local expected;
      node (fun () -> Bound local)
  | As (local, inner) ->
      bind ctx local expected;
      let inner = check ctx inner expected in
      node (fun () -> As (local, inner ()))
  | Tuple_of elements ->
      let types =
        match Type.expand expected.ty with
        | Tuple types when List.compare_lengths types elements = 0 -> types
        | Erroneous -> List.map (fun _ -> Type.Erroneous) elements
        | _ ->
            let types = List.map (fun _ -> Context.fresh ctx) elements in
            let before = errors ctx in
            let (), held = hold ctx (fun () -> expect ctx ~at:p.span expected (Tuple types)) in
            (match held with
            | [ mistake ] when types = [] && errors ctx > before ->
                replace ctx (Refutable_input { pattern = p; input = expected.ty; mistake })
            | held -> pass_on ctx held);
            types
      in
      let elements = List.map2 (check ctx) elements (Reason.components expected types) in
      node (fun () -> Tuple_of (List.map (fun build -> build ()) elements))
  | Array_of elements ->
      let element =
        match Type.expand expected.ty with
        | Data { tycon; arguments = [ _; element ]; _ } when tycon = Environment.array -> element
        | _ -> Context.fresh ctx
      in
      let size = Type.Size (List.length elements) in
      expect ctx ~at:p.span expected (Environment.array_of size element);
      let elements =
        List.map (fun p -> check ctx p (Reason.part Of_array expected element)) elements
      in
      node (fun () -> Array_of (List.map (fun build -> build ()) elements))
  | Constructed (name, arguments) ->
      let constructor = Environment.constructor ctx.reader.environment name in
      let ty, _ = use ctx ~at:p.span ~name:name.name constructor.scheme in
      let fields, result = Environment.fields constructor ty in
      expect ctx ~at:p.span expected result;
      let arguments =
        List.map2 (fun p ty -> check ctx p (Reason.part Of_data expected ty)) arguments fields
      in
      node (fun () -> Constructed (constructor.ir, List.map (fun build -> build ()) arguments))
  | Literal { negative; number } ->
      let ty, value = Literal.number ctx ~negative ~at:p.span number in
      expect ctx ~at:p.span expected ty;
      node (fun () -> Literal value)
