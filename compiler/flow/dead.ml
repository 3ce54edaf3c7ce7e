(* An instance, with what the search has to know of it. *)
type instance = {
  callee : int;
  arguments : Ir.atom array;  (** statics, then inputs *)
  mutable needed : bool;
}

type definition =
  | Undefined
  | Parameter of { node : int; number : int }  (** statics, then inputs *)
  | Equation of Ir.rhs
  | Output of { instance : instance; number : int }

type node = {
  parameters : Ir.signal array;  (** statics, then inputs *)
  outputs : Ir.atom array;
  needed_outputs : bool array;
  mutable needed_instances : instance list;
}

type search = {
  definitions : definition array;  (** by signal id *)
  needed : Bytes.t;  (** by signal id: is it? *)
  nodes : node array;
}

let joined first second = Array.of_list (List.rev_append (List.rev first) second)

let prepare (program : Ir.program) =
  let ids = Signals.next_id program in
  let definitions = Array.make ids Undefined in
  let define (s : Ir.signal) definition = definitions.(s.id) <- definition in
  let node index (node : Ir.node) =
    let parameters = joined node.statics node.inputs in
    Array.iteri (fun number s -> define s (Parameter { node = index; number })) parameters;
    List.iter (fun (e : Ir.equation) -> define e.defines (Equation e.rhs)) node.equations;
    List.iter
      (fun (i : Ir.instance) ->
        let instance =
          { callee = i.node; arguments = joined i.statics i.inputs; needed = false }
        in
        List.iteri (fun number s -> define s (Output { instance; number })) i.outputs)
      node.instances;
    let outputs = Array.of_list (List.rev (List.rev_map snd node.outputs)) in
    {
      parameters;
      outputs;
      needed_outputs = Array.make (Array.length outputs) false;
      needed_instances = [];
    }
  in
  let nodes = Array.mapi node program.nodes in
  { definitions; needed = Bytes.make ids '\000'; nodes }

let is_needed search (s : Ir.signal) = Bytes.get search.needed s.id <> '\000'

(* The atoms that are needed because this one is. *)
let consequences search (s : Ir.signal) =
  match search.definitions.(s.id) with
  | Undefined -> Basis.Diagnostic.bug ~stage:"Flow.Dead" "`%s` (%d) is not defined" s.name s.id
  | Equation rhs -> Operands.all rhs
  | Parameter { node; number } ->
      List.rev_map (fun i -> i.arguments.(number)) search.nodes.(node).needed_instances
  | Output { instance; number } ->
      let callee = search.nodes.(instance.callee) in
      let output =
        if callee.needed_outputs.(number) then []
        else begin
          callee.needed_outputs.(number) <- true;
          [ callee.outputs.(number) ]
        end
      in
      if instance.needed then output
      else begin
        instance.needed <- true;
        callee.needed_instances <- instance :: callee.needed_instances;
        let passed = ref output in
        Array.iteri
          (fun j a -> if is_needed search callee.parameters.(j) then passed := a :: !passed)
          instance.arguments;
        !passed
      end

let run search =
  let rec go = function
    | [] -> ()
    | Ir.Signal s :: rest when not (is_needed search s) ->
        Bytes.set search.needed s.id '\001';
        go (List.rev_append (consequences search s) rest)
    | (Ir.Signal _ | Bool _ | Int _ | Float _) :: rest -> go rest
  in
  let root = search.nodes.(Array.length search.nodes - 1) in
  Array.fill root.needed_outputs 0 (Array.length root.outputs) true;
  go (Array.to_list root.outputs)

(* Those of [items] whose [flags] are set, pairwise. *)
let select flags items =
  List.rev (List.fold_left2 (fun all flag item -> if flag then item :: all else all) [] flags items)

let sweep search (program : Ir.program) =
  let root = Array.length program.nodes - 1 in
  let is_needed = is_needed search in
  let stays index = index = root || search.nodes.(index).needed_instances <> [] in
  let numbers = Array.make (root + 1) (-1) in
  let count = ref 0 in
  Array.iteri
    (fun index _ ->
      if stays index then begin
        numbers.(index) <- !count;
        incr count
      end)
    program.nodes;
  let flags signals = List.rev (List.rev_map is_needed signals) in
  let instance (i : Ir.instance) =
    let callee = program.nodes.(i.node) in
    {
      i with
      node = numbers.(i.node);
      statics = select (flags callee.statics) i.statics;
      inputs = select (flags callee.inputs) i.inputs;
      outputs = select (Array.to_list search.nodes.(i.node).needed_outputs) i.outputs;
    }
  in
  let node index (node : Ir.node) =
    let instances =
      List.filter (fun (i : Ir.instance) -> List.exists is_needed i.outputs) node.instances
    in
    {
      node with
      statics = (if index = root then node.statics else List.filter is_needed node.statics);
      inputs = (if index = root then node.inputs else List.filter is_needed node.inputs);
      outputs = select (Array.to_list search.nodes.(index).needed_outputs) node.outputs;
      equations = List.filter (fun (e : Ir.equation) -> is_needed e.defines) node.equations;
      instances = List.rev (List.rev_map instance instances);
    }
  in
  let kept = List.filter stays (List.init (root + 1) Fun.id) in
  let nodes = List.rev_map (fun index -> node index program.nodes.(index)) kept in
  { program with nodes = Array.of_list (List.rev nodes) }

let program program =
  let search = prepare program in
  run search;
  sweep search program
