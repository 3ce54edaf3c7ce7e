open Basis
module Ir = Flow.Ir

type request = {
  kind : Ir.kind;
  name : string;
  span : Span.t;
  call : Span.t;
  result : Core.Ir.ty;
  statics : Skeleton.hole list;
  inputs : Skeleton.hole list;
  key : int;
}

let finish c node ~name ~origin ~span ~kind ~statics ~inputs ~outputs =
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
      span;
      file = span.Span.file;
    }

let output_name (hole : Skeleton.hole) =
  match hole.atom with
  | Signal { name; _ } when not (String.equal name "") -> name
  | Signal _ | Bool _ | Int _ | Float _ -> if String.equal hole.name "" then "out" else hole.name

let build (c : Context.t) trail request body : Context.specialization =
  Context.count c trail ~name:request.name ~span:request.call;
  let node = Node.create ~fresh:c.fresh in
  let parameter (hole : Skeleton.hole) =
    Node.signal node ~name:hole.name ~span:hole.span hole.ty
  in
  let statics = List.map parameter request.statics in
  let inputs = List.map parameter request.inputs in
  let parameters = statics @ inputs in
  let result = body node (List.map (fun s -> Ir.Signal s) parameters) in
  let walk = Skeleton.walk c.keys node in
  Skeleton.add walk ~name:"out" ~span:request.span request.result result;
  let holes = Skeleton.take_holes walk in
  let outputs = List.map (fun (hole : Skeleton.hole) -> hole.atom) holes in
  let callee : Context.callee =
    if Node.size node = 0 then Nothing parameters
    else
      Node
        (finish c node
           ~name:(Names.unique c.names request.name)
           ~origin:request.name ~span:request.span ~kind:request.kind ~statics ~inputs
           ~outputs:
             (List.map (fun (hole : Skeleton.hole) -> (output_name hole, hole.atom)) holes))
  in
  { callee; result; outputs }

(* The atoms of the caller for those of a node that only hands on. *)
let handed_on parameters actuals outputs =
  let actual = Hashtbl.create 8 in
  List.iter2 (fun (s : Ir.signal) atom -> Hashtbl.replace actual s.id atom) parameters actuals;
  let hand_on (atom : Ir.atom) =
    match atom with
    | Signal s -> Hashtbl.find actual s.id
    | Bool _ | Int _ | Float _ -> atom
  in
  List.map hand_on outputs

let ty_of_atom (atom : Ir.atom) : Ir.ty =
  match atom with Signal s -> s.ty | Bool _ -> Bool | Int _ -> Int | Float _ -> Float

let call (c : Context.t) trail caller target request body =
  let specialization =
    match Hashtbl.find_opt c.specializations request.key with
    | Some known -> known
    | None ->
        let built = build c trail request body in
        Hashtbl.replace c.specializations request.key built;
        built
  in
  let actual (hole : Skeleton.hole) = hole.atom in
  let statics = List.map actual request.statics in
  let inputs = List.map actual request.inputs in
  let atoms =
    match specialization.callee with
    | Nothing parameters -> handed_on parameters (statics @ inputs) specialization.outputs
    | Node node ->
        let layout = Types.layout c.types request.result in
        let targets =
          if layout.first_order then Node.leaves target layout.leaves
          else List.map (fun _ -> Node.Unnamed) specialization.outputs
        in
        Node.call caller targets ~callee:request.name ~node ~span:request.call ~statics ~inputs
          (List.map ty_of_atom specialization.outputs)
  in
  Skeleton.value (Skeleton.copy c.keys atoms) request.result specialization.result
