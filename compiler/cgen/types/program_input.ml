module M = Step.Ir

(* The arguments that calls pass for a parameter. *)
type passed = Leaf of int  (** this leaf of the input in every call *) | Different

type node = {
  passed : (int, passed) Hashtbl.t;  (** arguments, by the id of the parameter *)
  mutable refused : bool;
      (** true if the node cannot receive the pointer, because a caller does not have it, or because
          a call is a trial step or occurs in a loop or in an expression *)
  mutable given : bool;
}

type t = { leaves : Interface.step list array; nodes : node array }

let few = 3

let none (program : M.program) =
  let node _ = { passed = Hashtbl.create 1; refused = true; given = false } in
  { leaves = [||]; nodes = Array.map node program.nodes }

let is_given t k = t.nodes.(k).given

let member t k (v : M.variable) =
  if not (is_given t k) then None
  else
    match Hashtbl.find_opt t.nodes.(k).passed v.id with
    | Some (Leaf leaf) -> Some t.leaves.(leaf)
    | Some Different | None -> None

let is_leaf t k (v : M.variable) =
  match Hashtbl.find_opt t.nodes.(k).passed v.id with
  | Some (Leaf _) -> true
  | Some Different | None -> false

let reads_only_elements body (variable : M.variable) steps ~by_pointer =
  let dimensions = Interface.dimensions steps in
  let rec is_chain depth (e : M.expr) =
    match e with
    | Variable v -> depth = 0 && v.id = variable.id
    | Index { array; _ } -> is_chain (depth - 1) array
    | _ -> false
  in
  let is_variable (v : M.variable) = v.id = variable.id in
  let reads = ref 0 and apart = ref (List.length (List.filter is_variable by_pointer)) in
  Step.Walk.expressions
    (fun e ->
      (match e with M.Variable v when is_variable v -> incr reads | _ -> ());
      if is_chain dimensions e then incr apart)
    body;
  Step.Walk.statements
    (function
      | M.Loop l ->
          List.iter
            (function
              | M.Each e -> if is_chain (dimensions - 1) e then incr apart
              | Accumulated _ | Same _ | Counted _ -> ())
            l.arguments
      | _ -> ())
    body;
  !reads = !apart

(* Call this after all callers have been processed. *)
let decide t k (node : M.node) =
  let own = t.nodes.(k) in
  (* An array can be read through the pointer only if the node never needs it as a whole, because
     arrays in the input have a different C type from local arrays. *)
  let check (v : M.variable) =
    match Hashtbl.find_opt own.passed v.id with
    | Some (Leaf leaf)
      when Interface.is_in_array t.leaves.(leaf)
           && not (reads_only_elements node.step.body v t.leaves.(leaf) ~by_pointer:[]) ->
        Hashtbl.replace own.passed v.id Different
    | Some (Leaf _ | Different) | None -> ()
  in
  List.iter check node.step.parameters;
  let leaves = List.filter (is_leaf t k) node.step.parameters in
  let different = Hashtbl.create 8 in
  let note (v : M.variable) = Hashtbl.replace different (Hashtbl.find own.passed v.id) () in
  List.iter note leaves;
  own.given <- (not own.refused) && Option.is_none node.foreign && Hashtbl.length different >= few

let note_call t ~from ~node parameters arguments =
  let callee = t.nodes.(node) in
  if not (is_given t from) then callee.refused <- true;
  let note (v : M.variable) (argument : M.expr) =
    let passed =
      match argument with
      | Variable given ->
          Option.value (Hashtbl.find_opt t.nodes.(from).passed given.id) ~default:Different
      | _ -> Different
    in
    let joined =
      match Hashtbl.find_opt callee.passed v.id with
      | Some before when before <> passed -> Different
      | Some _ | None -> passed
    in
    Hashtbl.replace callee.passed v.id joined
  in
  List.iter2 note parameters arguments

(* Visits all calls that are statements in a body, except those in loops. *)
let calls f (program : M.program) (node : M.node) body =
  let step k arguments = f k program.nodes.(k).step.parameters arguments in
  let case (mode : M.mode) (case : M.case) = step mode.node case.arguments in
  Step.Walk.statements
    (function
      | M.Step { node; arguments; _ } -> step node arguments
      | Run { cases; _ } -> List.iter2 case node.modes cases
      | Declare _ | Assign _ | If _ | Loop _ | Reset _ | Enter _ | Return _ -> ())
    body

let variables_by_pointer t (program : M.program) node body =
  let found = ref [] in
  calls
    (fun callee parameters arguments ->
      List.iter2
        (fun v (argument : M.expr) ->
          match argument with
          | Variable given when Option.is_some (member t callee v) -> found := given :: !found
          | _ -> ())
        parameters arguments)
    program node body;
  !found

let note_calls t (program : M.program) k =
  let node = program.nodes.(k) in
  let refuse k = t.nodes.(k).refused <- true in
  calls (fun callee -> note_call t ~from:k ~node:callee) program node node.step.body;
  Step.Walk.statements
    (function
      | M.Step { node; on_trial = true; _ } | Loop { node; _ } -> refuse node
      | Step _ | Run _ | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Return _ -> ())
    node.step.body;
  Step.Walk.expressions (function M.Call { node; _ } -> refuse node | _ -> ()) node.step.body

let of_program (program : M.program) (input : Interface.t) =
  if List.compare_length_with input.leaves few < 0 then none program
  else
    let node _ = { passed = Hashtbl.create 8; refused = false; given = false } in
    let t = { leaves = Array.of_list input.leaves; nodes = Array.map node program.nodes } in
    let root = Array.length program.nodes - 1 in
    let own leaf (v : M.variable) = Hashtbl.replace t.nodes.(root).passed v.id (Leaf leaf) in
    List.iteri own program.nodes.(root).step.parameters;
    t.nodes.(root).given <- true;
    note_calls t program root;
    for k = root - 1 downto 0 do
      decide t k program.nodes.(k);
      note_calls t program k
    done;
    t
