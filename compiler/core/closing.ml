let program (p : Ir.program) (d : Ir.definition) ~suffix ~input ~output =
  let name : Ir.Global.t = { d.name with name = d.name.name ^ suffix } in
  match d.ty with
  | Data (tycon, [ i; o ]) ->
      let solve (t : Ir.ty) closed = match t with Variable v -> [ (v.id, closed) ] | _ -> [] in
      let solved = solve i input @ solve o output in
      let type_of (v : Ir.variable) : Ir.ty =
        match List.assoc_opt v.id solved with Some ty -> ty | None -> Tuple []
      in
      let ty : Ir.ty = Data (tycon, [ input; output ]) in
      let body : Ir.expr =
        { desc = Global (d.name, List.map type_of d.parameters); ty; span = d.span }
      in
      let closed : Ir.definition = { name; parameters = []; ty; body; span = d.span } in
      ({ p with definitions = p.definitions @ [ closed ] }, name)
  | _ -> Basis.Diagnostic.bug ~stage:"Core.Closing" "`%s` is no program" d.name.name
