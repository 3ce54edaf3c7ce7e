(* [definitions]: all library definitions. [found]: those reached so far. *)
type search = { definitions : Ir.binding Global_table.t; found : unit Global_table.t }

let rec expr search (e : Ir.expr) =
  match e.desc with
  | Global g -> mention search g
  | Field { record; field; candidates = [] } ->
      (* not a field, but possibly a function with that name, which the error message will then
         mention *)
      mention_all search field.text;
      expr search record
  | _ -> Walk.expr (visitor search) e

and binding search b = Walk.binding (visitor search) b

and visitor search : Walk.visitor =
  { expr = expr search; pattern = ignore; binding = binding search }

and mention_all search name =
  Global_table.fold
    (fun (g : Ir.Global.t) _ found -> if String.equal g.name name then g :: found else found)
    search.definitions []
  |> List.iter (mention search)

and mention search g =
  match Global_table.find_opt search.definitions g with
  | Some definition when not (Global_table.mem search.found g) ->
      Global_table.replace search.found g ();
      binding search definition
  | Some _ | None -> ()

let program ~keep (program : Ir.program) =
  let own_modules = Basis.String_table.create 16 in
  List.iter
    (fun (m : Ir.module_) ->
      if String.equal m.name program.main_module || not m.library then
        Basis.String_table.replace own_modules m.name ())
    program.modules;
  let is_own_module name = Basis.String_table.mem own_modules name in
  let search = { definitions = Global_table.create 512; found = Global_table.create 512 } in
  let is_own (b : Ir.binding) =
    match b.name with Top (g, _) -> is_own_module g.module_ | Inner _ | Destructure _ -> true
  in
  let each f = List.iter (fun (g : Ir.binding_group) -> List.iter f g.bindings) program.groups in
  each (fun b ->
      match b.name with
      | Top (g, _) when not (is_own b) -> Global_table.replace search.definitions g b
      | Top _ | Inner _ | Destructure _ -> ());
  List.iter (mention search) keep;
  each (fun b -> if is_own b then binding search b);
  List.iter
    (fun (c : Ir.class_) ->
      List.iter (fun (m : Ir.method_) -> Option.iter (binding search) m.default) c.methods)
    program.classes;
  List.iter
    (fun (i : Ir.instance) -> List.iter (fun (_, b) -> binding search b) i.definitions)
    program.instances;
  let is_here (p : Ir.param) =
    is_own_module p.param.module_ || Global_table.mem search.found p.param
  in
  List.iter
    (fun (p : Ir.param) -> if is_here p then Option.iter (mention search) p.given)
    program.params;
  let stays (b : Ir.binding) =
    is_own b
    ||
    match b.name with
    | Top (g, _) -> Global_table.mem search.found g
    | Inner _ | Destructure _ -> true
  in
  (* If one binding of a group is kept, all are, because it reaches the others. *)
  let stays (g : Ir.binding_group) = List.exists stays g.bindings in
  let groups = List.filter stays program.groups in
  { program with groups; params = List.filter is_here program.params }
