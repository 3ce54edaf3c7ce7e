open Basis
module Ir = Flow.Ir

let letter k =
  if k < 26 then String.make 1 (Char.chr (Char.code 'a' + k)) else Printf.sprintf "a%d" k

let import types (f : Core.Primitive.foreign) ~arguments ~result : Ir.import =
  {
    symbol = f.symbol;
    kind = (match f.kind with Stateless _ -> Function | Stateful -> Signal_function);
    arguments = List.map (Types.shape types) arguments;
    result = Types.shape types result;
  }

let imports (c : Context.t) =
  let is_called symbol (node : Ir.node) =
    match node.foreign with
    | Some { import; _ } -> String.equal import.symbol symbol
    | None -> false
  in
  let is_needed (f : Core.Primitive.foreign) =
    (not (Context.in_library c f.span)) || List.exists (is_called f.symbol) c.nodes
  in
  let add imports ((f : Core.Primitive.foreign), ty) =
    let is_known (i : Ir.import) = String.equal i.symbol f.symbol in
    if List.exists is_known imports || not (is_needed f) then imports
    else
      let rec split (ty : Core.Ir.ty) arguments =
        match (f.kind, ty) with
        | Stateless _, Function (a, b) -> split b (a :: arguments)
        | Stateful, Signal_function (a, b) -> ([ a ], b)
        | _, result -> (List.rev arguments, result)
      in
      let arguments, result = split ty [] in
      import c.types f ~arguments ~result :: imports
  in
  List.rev (List.fold_left add [] c.foreign.values)

let build (p : Evaluator.position) (f : Core.Primitive.foreign) ~result arguments =
  let c = p.context in
  let node = Node.create ~fresh:c.fresh in
  let signals name ty =
    List.map
      (fun (leaf : Types.leaf) ->
        Node.signal node ~name:(Types.join name (Types.path_name leaf)) ~span:f.span leaf.leaf)
      (Types.layout c.types ty).leaves
  in
  let types = List.map (fun (a : Value.argument) -> a.ty) arguments in
  let import = import c.types f ~arguments:types ~result in
  let results = signals "out" result in
  Context.add_node c
    {
      name = Names.unique c.names f.foreign_name;
      origin = f.foreign_name;
      kind = import.kind;
      statics = [];
      inputs = List.concat (List.mapi (fun k ty -> signals (letter k) ty) types);
      outputs = List.map (fun (s : Ir.signal) -> (s.name, Ir.Signal s)) results;
      equations = [];
      instances = [];
      foreign = Some { import; results };
      machine = None;
      transitions = [];
      span = f.span;
      file = f.span.file;
    }

(* All calls to a foreign function share one node. *)
let node (p : Evaluator.position) f ~result arguments =
  let c = p.context in
  let walk = Specialization_key.walk c.keys p.node Holes in
  Specialization_key.add_text walk (Core.Primitive_table.key (Foreign f));
  let key = Specialization_key.key walk in
  match Variables.Table.find_opt c.specializations key with
  | Some { callee = Node known; _ } -> known
  | Some { callee = Nothing _; _ } | None ->
      let node = build p f ~result arguments in
      Variables.Table.replace c.specializations key
        { callee = Node node; result = Unspecified; outputs = [] };
      node

let apply (p : Evaluator.position) target (f : Core.Primitive.foreign) ~result arguments =
  let node = node p f ~result arguments in
  let leaves = (Types.layout p.types result).leaves in
  let atoms (a : Value.argument) = Leaves.atoms p.types p.node ~span:p.span a.ty a.value in
  let outputs =
    Node.call p.node (Node.leaves target leaves) ~callee:f.foreign_name ~node ~span:p.span
      ~statics:[] ~inputs:(List.concat_map atoms arguments)
      (List.map (fun (leaf : Types.leaf) -> leaf.leaf) leaves)
  in
  Leaves.value p.types result outputs

(* Detects C components whose struct and functions would have the same names as those of the
   program. *)
let check_names (c : Context.t) ~name =
  (* For example, [my-robot.frob] defines [my_robot_step]. *)
  let prefix = String.map (fun c -> if c = '-' || c = ' ' || c = '.' then '_' else c) name in
  let collides ((f : Core.Primitive.foreign), _) =
    match f.kind with
    | Stateful -> String.equal f.symbol prefix
    | Stateless _ -> List.mem f.symbol [ prefix ^ "_reset"; prefix ^ "_step" ]
  in
  let is_own (h : Core.Ir.header) = String.equal h.header (name ^ ".h") in
  let report fact = Context.report c (Foreign_name fact) in
  match List.find_opt collides c.foreign.values with
  | Some (foreign, _) -> report (Function_or_component foreign)
  | None -> List.iter (fun h -> report (Header h)) (List.filter is_own c.foreign.headers)
