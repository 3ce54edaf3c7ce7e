type clause = Rejection.clause = {
  name : Ir.name;
  parameters : Ir.pattern list;
  right : Ir.right;
  span : Basis.Span.t;
}

let clause (d : Ir.declaration) =
  match d.desc with
  | Binding { left = Function_name { name; parameters }; right; _ } ->
      Some { name; parameters; right; span = d.span }
  | _ -> None

let joined declarations =
  let finish first others told =
    match (first, List.rev others) with
    | Some first, second :: others -> Rejection.Several_clauses { first; second; others } :: told
    | _ -> told
  in
  let add (kept, first, others, told) d =
    match (first, clause d) with
    | Some f, Some c when String.equal f.name.text c.name.text -> (kept, first, c :: others, told)
    | _, c -> (d :: kept, c, [], finish first others told)
  in
  let kept, first, others, told = List.fold_left add ([], None, [], []) declarations in
  (List.rev kept, List.rev (finish first others told))
