module Ir = Flow.Ir

let letter k = if k < 26 then String.make 1 (Char.chr (Char.code 'a' + k)) else Printf.sprintf "a%d" k

let build (p : Comparison.position) (f : Core.Primitive.foreign) ~result arguments =
  let c = p.context in
  let node = Node.create ~fresh:c.fresh in
  let signals name ty =
    List.map
      (fun (leaf : Types.leaf) ->
        Node.signal node ~name:(Types.join name leaf.path) ~span:f.span leaf.leaf)
      (Types.layout c.types ty).leaves
  in
  let types = List.map (fun (a : Value.argument) -> a.ty) arguments in
  let kind : Ir.kind =
    match f.kind with Stateless _ -> Function | Stateful -> Signal_function
  in
  let results = signals "out" result in
  Context.add_node c
    {
      name = Names.unique c.names f.foreign_name;
      origin = f.foreign_name;
      kind;
      statics = [];
      inputs = List.concat (List.mapi (fun k ty -> signals (letter k) ty) types);
      outputs = List.map (fun (s : Ir.signal) -> (s.name, Ir.Signal s)) results;
      equations = [];
      instances = [];
      foreign =
        Some
          {
            symbol = f.symbol;
            arguments = List.map (Types.shape c.types) types;
            result = Types.shape c.types result;
            results;
          };
      machine = None;
      transitions = [];
      span = f.span;
      file = f.span.file;
    }

(* The same for all calls. *)
let node (p : Comparison.position) f ~result arguments =
  let c = p.context in
  let walk = Skeleton.walk c.keys p.node Holes in
  Skeleton.add_text walk (Core.Primitive.key (Foreign f));
  let key = Skeleton.key walk in
  match Variables.Table.find_opt c.specializations key with
  | Some { callee = Node known; _ } -> known
  | Some { callee = Nothing _; _ } | None ->
      let node = build p f ~result arguments in
      Variables.Table.replace c.specializations key
        { callee = Node node; result = Unspecified; outputs = [] };
      node

let apply (p : Comparison.position) target (f : Core.Primitive.foreign) ~result arguments =
  let node = node p f ~result arguments in
  let leaves = (Types.layout p.types result).leaves in
  let atoms (a : Value.argument) = Leaves.atoms p.types p.node ~span:p.span a.ty a.value in
  let outputs =
    Node.call p.node (Node.leaves target leaves) ~callee:f.foreign_name ~node ~span:p.span
      ~statics:[]
      ~inputs:(List.concat_map atoms arguments)
      (List.map (fun (leaf : Types.leaf) -> leaf.leaf) leaves)
  in
  Leaves.value p.types result outputs
