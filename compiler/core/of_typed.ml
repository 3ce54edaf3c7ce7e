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
    constructors = Basis.Long_list.map constructor d.constructors;
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

let foreign (f : T.foreign) : Ir.foreign =
  let value (v : T.foreign_value) : Primitive.foreign * Ir.ty =
    let rec arity : T.ty -> int = function Function (_, b) -> 1 + arity b | _ -> 0 in
    let kind : Primitive.foreign_kind =
      match v.kind with
      | Foreign_function -> Stateless (arity v.ty)
      | Foreign_signal_function -> Stateful
    in
    ( {
        module_ = v.name.module_;
        foreign_name = v.name.name;
        symbol = v.symbol;
        kind;
        span = v.span;
      },
      Erasure.ty v.ty )
  in
  {
    headers =
      List.map (fun (h : T.header) -> { Ir.header = h.header; of_file = h.of_file }) f.headers;
    types =
      List.map
        (fun (t : T.foreign_type) ->
          { Ir.foreign_type = t.tycon; c_type = t.c_type; copyable = t.copyable })
        f.foreign_types;
    values = List.map value f.values;
  }

(* If several parameters share a name, only the one in the main module has a label without the
   module. *)
let params (p : T.program) =
  let label (param : T.param) =
    let namesake (q : T.param) = String.equal q.param.name param.param.name in
    match List.filter namesake p.params with
    | _ :: _ :: _ when not (String.equal param.param.module_ p.main_module) ->
        param.param.module_ ^ "." ^ param.param.name
    | _ -> param.param.name
  in
  let unit_ : T.ty -> string = function Number (_, unit_) -> Typing.Show.unit_ unit_ | _ -> "" in
  List.map
    (fun (param : T.param) : Ir.param ->
      {
        param = param.param;
        given = param.given;
        label = label param;
        ty = Erasure.ty param.ty;
        unit_ = unit_ param.ty;
        doc = param.doc;
        span = param.span;
      })
    p.params

let define ctx lifted (d : T.definition) =
  let parameters = Erasure.parameters d.scheme in
  let body = Expression.closed ctx lifted ~name:d.name parameters d.value in
  Context.define ctx { name = d.name; parameters; ty = Erasure.ty d.scheme.ty; body; span = d.span }

let program (p : T.program) : Ir.program =
  let is_built_in (d : T.data) = List.mem d.tycon [ Erasure.boolean; Erasure.array ] in
  let data =
    List.rev
      (List.fold_left (fun found d -> if is_built_in d then found else data d :: found) [] p.data)
  in
  let instances = List.map instance p.instances in
  let foreign = foreign p.foreign in
  let ctx = Context.create data instances foreign in
  List.iter (define ctx (Lifting.table ())) p.definitions;
  let definitions = Context.definitions ctx in
  {
    main_module = p.main_module;
    real = p.real;
    data;
    instances;
    foreign;
    console = [];
    definitions = (if instances = [] then definitions else Order.definitions definitions);
    params = params p;
  }
