let program (p : Ir.program) (d : Ir.definition) ~suffix ~input ~output =
  let name : Ir.Global.t = { d.name with name = d.name.name ^ suffix } in
  let closed i o of_ends =
    let solve (t : Ir.ty) closed = match t with Variable v -> [ (v.id, closed) ] | _ -> [] in
    let solved = solve i input @ solve o output in
    let type_of (v : Ir.variable) : Ir.ty =
      match List.assoc_opt v.id solved with Some ty -> ty | None -> Tuple []
    in
    let end_ (t : Ir.ty) closed = match t with Variable _ -> closed | t -> t in
    let ty : Ir.ty = of_ends (end_ i input) (end_ o output) in
    let body : Ir.expr =
      { desc = Global (d.name, List.map type_of d.parameters); ty; span = d.span }
    in
    let closed : Ir.definition = { name; parameters = []; ty; body; span = d.span } in
    ({ p with definitions = p.definitions @ [ closed ] }, name)
  in
  match d.ty with
  | Data (tycon, [ i; o ]) -> closed i o (fun i o -> Data (tycon, [ i; o ]))
  | Signal_function (i, o) -> closed i o (fun i o -> Signal_function (i, o))
  | _ -> Basis.Diagnostic.bug ~stage:"Core.Closing" "`%s` is not a program" d.name.name
