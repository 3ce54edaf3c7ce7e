module T = Typing.Ir

let data (d : T.data) : Ir.data =
  let constructor (c : T.constructor) : Ir.constructor =
    {
      name = c.constructor;
      record = c.record;
      fields = List.map (fun (name, ty) -> (name, Erasure.ty ty)) c.fields;
    }
  in
  {
    tycon = d.tycon;
    parameters = List.map Erasure.variable d.type_parameters;
    constructors = List.rev (List.rev_map constructor d.constructors);
    span = d.span;
  }

let definition ctx (d : T.definition) : Ir.definition =
  {
    name = d.name;
    parameters = Erasure.parameters d.scheme;
    ty = Erasure.ty d.scheme.ty;
    body = Expression.closed ctx ~name:d.name.name d.value;
    span = d.span;
  }

let program (p : T.program) : Ir.program =
  let is_boolean (d : T.data) = d.tycon = Erasure.boolean in
  let data =
    List.rev
      (List.fold_left
         (fun found d -> if is_boolean d then found else data d :: found)
         [] p.data)
  in
  let ctx = Context.create data in
  {
    main_module = p.main_module;
    data;
    definitions = List.rev (List.rev_map (definition ctx) p.definitions);
  }
