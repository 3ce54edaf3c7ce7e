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

let instance (i : T.instance) : Ir.instance =
  let implementation : T.implementation -> Ir.implementation = function
    | Given g -> Given g
    | Default g -> Default g
  in
  {
    class_ = i.class_;
    head = Erasure.ty i.head;
    methods = List.map (fun ((m : Ir.Global.t), by) -> (m.name, implementation by)) i.methods;
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
  let is_built_in (d : T.data) = List.mem d.tycon [ Erasure.boolean; Erasure.array ] in
  let data =
    List.rev
      (List.fold_left
         (fun found d -> if is_built_in d then found else data d :: found)
         [] p.data)
  in
  let instances = List.map instance p.instances in
  let ctx = Context.create data instances in
  let definitions = List.rev (List.rev_map (definition ctx) p.definitions) in
  {
    main_module = p.main_module;
    data;
    instances;
    definitions = (if instances = [] then definitions else Order.definitions definitions);
  }
