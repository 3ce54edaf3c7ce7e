open Basis

(* Whether it takes longer to call the function again than to pass its result. *)
let is_costly : Core.Primitive.elementary -> bool = function
  | Floor_float | Ceiling_float | Nanoseconds -> false
  | Sqrt | Hypot | Exp | Log | Sin | Cos | Tan | Asin | Acos | Atan | Atan2 -> true

type value = { function_ : Core.Primitive.elementary; arguments : Ir.atom list }

(* Within a node, equations with equal keys have equal values. *)
let key value = (value.function_, List.map Operands.key value.arguments)

let costly (e : Ir.equation) =
  match e.rhs with
  | Op (Elementary function_, arguments) when is_costly function_ -> Some { function_; arguments }
  | _ -> None

(* The values that a node computes from inputs alone, with their equations. Some arguments may be
   literals, but not all: a value computed only from literals is known before the program starts,
   and would no longer be known if it were an input. *)
let candidates (node : Ir.node) =
  let is_input (a : Ir.atom) =
    match a with
    | Signal s -> List.exists (fun (input : Ir.signal) -> input.id = s.id) node.inputs
    | Bool _ | Int _ | Float _ -> true
  in
  let candidate e =
    match costly e with
    | Some value
      when List.for_all is_input value.arguments && Operands.signals value.arguments <> [] ->
        Some (e, value)
    | Some _ | None -> None
  in
  if node.foreign = None then List.filter_map candidate node.equations else []

(* The value in terms of the caller's signals; [None] if an argument changes between the iterations
   of a loop. *)
let at_call (node : Ir.node) (i : Ir.instance) value =
  let kinds =
    match i.loop with Some l -> l.arguments | None -> List.map (fun _ -> Ir.Same) i.inputs
  in
  let inputs = List.combine node.inputs (List.combine kinds i.inputs) in
  let passed (a : Ir.atom) =
    match a with
    | Bool _ | Int _ | Float _ -> Some a
    | Signal s -> (
        match List.find_opt (fun ((input : Ir.signal), _) -> input.id = s.id) inputs with
        | Some (_, (Ir.Same, atom)) -> Some atom
        | Some (_, ((Accumulator | Element | Counter), _)) | None -> None)
  in
  let arguments = List.map passed value.arguments in
  if List.for_all Option.is_some arguments then
    Some { value with arguments = List.filter_map Fun.id arguments }
  else None

(* Nodes for which callers cannot compute values. *)
let closed (program : Ir.program) =
  let closed = Array.map Option.is_some (Transitions.owners program) in
  closed.(Array.length closed - 1) <- true;
  let instance (i : Ir.instance) = if i.trials <> [] then closed.(i.node) <- true in
  Array.iter (fun (node : Ir.node) -> List.iter instance node.instances) program.nodes;
  closed

(* For each node, the candidates that are worth moving. *)
let choose (program : Ir.program) =
  let closed = closed program in
  let found = Array.mapi (fun k node -> if closed.(k) then [] else candidates node) program.nodes in
  let useful = Hashtbl.create 16 and impossible = Hashtbl.create 16 in
  let caller (node : Ir.node) =
    let counts = Hashtbl.create 16 in
    let count key =
      Hashtbl.replace counts key (1 + Option.value (Hashtbl.find_opt counts key) ~default:0)
    in
    List.iter (fun e -> Option.iter (fun v -> count (key v)) (costly e)) node.equations;
    let calls =
      List.concat_map
        (fun (i : Ir.instance) ->
          List.map
            (fun ((e : Ir.equation), value) ->
              (i, e.defines.id, at_call program.nodes.(i.node) i value))
            found.(i.node))
        node.instances
    in
    List.iter (fun (_, _, value) -> Option.iter (fun v -> count (key v)) value) calls;
    let judge ((i : Ir.instance), id, value) =
      match value with
      | None -> Hashtbl.replace impossible id ()
      | Some value ->
          let repeats = Option.fold i.loop ~none:1 ~some:(fun (l : Ir.loop) -> l.count) in
          if repeats * Hashtbl.find counts (key value) > 1 then Hashtbl.replace useful id ()
    in
    List.iter judge calls
  in
  Array.iter caller program.nodes;
  let is_chosen ((e : Ir.equation), _) =
    Hashtbl.mem useful e.defines.id && not (Hashtbl.mem impossible e.defines.id)
  in
  Array.map (List.filter is_chosen) found

let signal ~fresh (like : Ir.signal) : Ir.signal =
  let id = fresh () in
  { like with id; group = id }

(* Replaces each moved value with a new input of the node. *)
let callee ~fresh moved (node : Ir.node) =
  let inputs = List.map (fun ((e : Ir.equation), _) -> (e, signal ~fresh e.defines)) moved in
  let equation (e : Ir.equation) =
    match List.assq_opt e inputs with
    | Some input -> { e with rhs = Copy (Signal input) }
    | None -> e
  in
  let equations = Long_list.map equation node.equations in
  { node with inputs = node.inputs @ List.map snd inputs; equations }

let caller ~fresh moved (program : Ir.program) (node : Ir.node) =
  let added = ref [] in
  let pass (i : Ir.instance) ((e : Ir.equation), value) : Ir.atom =
    let { function_; arguments } = Option.get (at_call program.nodes.(i.node) i value) in
    let defines = signal ~fresh e.defines in
    added := { e with defines; rhs = Op (Elementary function_, arguments) } :: !added;
    Signal defines
  in
  let instance (i : Ir.instance) =
    match moved.(i.node) with
    | [] -> i
    | values ->
        let same (l : Ir.loop) =
          { l with arguments = l.arguments @ List.map (fun _ -> Ir.Same) values }
        in
        { i with inputs = i.inputs @ List.map (pass i) values; loop = Option.map same i.loop }
  in
  let instances = Long_list.map_sharing instance node.instances in
  if instances == node.instances then node
  else { node with instances; equations = node.equations @ List.rev !added }

let round (program : Ir.program) =
  let moved = choose program in
  if Array.for_all (fun values -> values = []) moved then program
  else
    let next = ref program.next_id in
    let fresh () =
      let id = !next in
      incr next;
      id
    in
    let node k (node : Ir.node) =
      let node = caller ~fresh moved program node in
      if moved.(k) = [] then node else callee ~fresh moved.(k) node
    in
    let nodes = Array.mapi node program.nodes in
    (* Callers that compute a value twice now compute it once. *)
    Common_subexpressions.program { program with nodes; next_id = !next }

(* Maximum number of rounds, each of which moves values from nodes to their callers. *)
let most_rounds = 4

let program program =
  let rec go k before =
    let after = round before in
    if after == before || k = 1 then after else go (k - 1) after
  in
  go most_rounds program
