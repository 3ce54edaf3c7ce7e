open Basis
module Ir = Flow.Ir

type request = {
  kind : Ir.kind;
  name : string;
  span : Span.t;
  call : Span.t;
  result : Core.Ir.ty;
  names : Destructuring.t;
  statics : Specialization_key.hole list;
  inputs : Specialization_key.hole list;
  key : int;
}

let finish c node ~name ~origin ~span ~kind ~statics ~inputs ~outputs ~transitions =
  Context.add_node c
    {
      name;
      origin;
      kind;
      statics;
      inputs;
      outputs;
      equations = Node.equations node;
      instances = Node.instances node;
      foreign = None;
      machine = Node.machine node;
      transitions;
      span;
      file = span.Span.file;
    }

(* The name of an output: the programmer's name if the output is a variable, otherwise one derived
   from its path. *)
let output_name taken (hole : Specialization_key.hole) =
  Names.unique taken
    (match hole.atom with
    | Signal { name; _ } when not (String.equal name "") -> name
    | Signal _ | Bool _ | Int _ | Float _ -> Types.join hole.local.name hole.path)

let build (c : Context.t) request body : Context.specialization =
  let node = Node.create ~fresh:c.fresh in
  let parameter (hole : Specialization_key.hole) =
    let name = Destructuring.name request.names hole.local hole.path in
    Node.signal node ~name ~span:hole.local.span hole.ty
  in
  let statics = List.map parameter request.statics in
  let inputs = List.map parameter request.inputs in
  let parameters = statics @ inputs in
  let result = body node (List.map (fun s -> Ir.Signal s) parameters) in
  let walk = Specialization_key.walk c.keys node Holes in
  Specialization_key.add walk { id = 0; name = "out"; span = request.span } request.result result;
  let holes = Specialization_key.take_holes walk in
  let outputs = List.map (fun (hole : Specialization_key.hole) -> hole.atom) holes in
  let callee : Context.callee =
    if Node.size node = 0 then Nothing parameters
    else
      let taken = Names.create () in
      let output (hole : Specialization_key.hole) = (output_name taken hole, hole.atom) in
      Node
        (finish c node
           ~name:(Names.unique c.names request.name)
           ~origin:request.name ~span:request.span ~kind:request.kind ~statics ~inputs
           ~outputs:(List.map output holes) ~transitions:[])
  in
  { callee; result; outputs }

(* The outputs of a node that only forwards its inputs, as atoms of the caller. *)
let handed_on parameters actuals outputs =
  let add known (s : Ir.signal) atom = Variables.add s.id atom known in
  let known = List.fold_left2 add Variables.empty parameters actuals in
  let hand_on (atom : Ir.atom) =
    match atom with Signal s -> Variables.find s.id known | Bool _ | Int _ | Float _ -> atom
  in
  List.map hand_on outputs

let find (c : Context.t) trail request body =
  match Variables.Table.find_opt c.specializations request.key with
  | Some known -> known
  | None ->
      let add trail =
        let built = build c request (body trail) in
        Context.count c trail ~name:request.name ~span:request.call;
        Variables.Table.replace c.specializations request.key built;
        built
      in
      if Context.nests_deeply c trail then
        raise (Context.Postponed (fun () -> ignore (add (Context.from_here trail))));
      add trail

let call (c : Context.t) trail caller target request body =
  let specialization = find c trail request body in
  let actual (hole : Specialization_key.hole) = hole.atom in
  let statics = List.map actual request.statics in
  let inputs = List.map actual request.inputs in
  let atoms =
    match specialization.callee with
    | Nothing parameters -> handed_on parameters (statics @ inputs) specialization.outputs
    | Node node ->
        Context.defining c trail request.result;
        let layout = Types.layout c.types request.result in
        let targets =
          if layout.first_order then Node.leaves target layout.leaves
          else List.map (fun _ -> Node.Unnamed) specialization.outputs
        in
        Node.call caller targets ~callee:request.name ~node ~span:request.call ~statics ~inputs
          (List.map Flow.Operands.ty specialization.outputs)
  in
  Specialization_key.value
    (Specialization_key.copy c.keys Holes atoms)
    request.result specialization.result
