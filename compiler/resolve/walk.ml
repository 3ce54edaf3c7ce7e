type visitor = {
  expr : Ir.expr -> unit;
  pattern : Ir.pattern -> unit;
  binding : Ir.binding -> unit;
}

let declarations v (ds : Ir.declarations) =
  List.iter (fun (g : Ir.binding_group) -> List.iter v.binding g.bindings) ds.groups

let right v (r : Ir.right) =
  declarations v r.where;
  let guarded (g : Ir.guarded) =
    Option.iter v.expr g.condition;
    v.expr g.value
  in
  List.iter guarded r.guards

let binding v (b : Ir.binding) =
  List.iter v.pattern b.parameters;
  right v b.body

let expr v (e : Ir.expr) =
  match e.desc with
  | Local _ | Global _ | Constructor _ | Number _ | String _ -> ()
  | Tuple es | Array es -> List.iter v.expr es
  | Apply { head; argument; style = _ } ->
      v.expr head;
      v.expr argument
  | Negate e
  | Power { base = e; exponent = _ }
  | Field { record = e; field = _; candidates = _ }
  | Annotated { expr = e; scheme = _ } ->
      v.expr e
  | If { condition; then_; else_ } -> List.iter v.expr [ condition; then_; else_ ]
  | Case { scrutinee; branches } ->
      v.expr scrutinee;
      let branch (b : Ir.branch) =
        v.pattern b.pattern;
        right v b.right
      in
      List.iter branch branches
  | Let { declarations = ds; body } ->
      declarations v ds;
      v.expr body
  | Lambda { parameters; body } ->
      List.iter v.pattern parameters;
      v.expr body
  | Proc { input; body } ->
      v.pattern input;
      declarations v body.equations;
      v.expr body.output
  | Sequence { statements; result } ->
      let statement : Ir.statement -> unit = function
        | Task { pattern; task } ->
            v.expr task;
            Option.iter v.pattern pattern
        | Values ds -> declarations v ds
      in
      List.iter statement statements;
      v.expr result
  | Record { constructor = _; fields } -> List.iter (fun (_, e) -> v.expr e) fields
  | Update { record; fields; candidates = _ } ->
      v.expr record;
      List.iter (fun (_, e) -> v.expr e) fields

let application e =
  let rec go (e : Ir.expr) arguments =
    match e.desc with
    | Apply { head; argument; _ } -> go head (argument :: arguments)
    | _ -> (e, arguments)
  in
  go e []

let own_modules (program : Ir.program) =
  let is_own (m : Ir.module_) = (not m.library) || String.equal m.name program.main_module in
  List.filter is_own program.modules

let own (program : Ir.program) =
  let modules = Basis.String_table.create 16 in
  let add (m : Ir.module_) = Basis.String_table.replace modules m.name () in
  List.iter add (own_modules program);
  let here (g : Ir.Global.t) = Basis.String_table.mem modules g.module_ in
  let bindings = List.concat_map (fun (g : Ir.binding_group) -> g.bindings) program.groups in
  let is_here (b : Ir.binding) =
    match b.name with Top (g, _) -> here g | Inner _ | Destructure _ -> true
  in
  let defaults (c : Ir.class_) = List.filter_map (fun (m : Ir.method_) -> m.default) c.methods in
  let methods (i : Ir.instance) = List.map snd i.definitions in
  List.filter is_here
    (bindings @ List.concat_map defaults program.classes @ List.concat_map methods program.instances)
