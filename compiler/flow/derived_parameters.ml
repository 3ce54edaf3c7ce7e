open Basis

(* Parameters of a node of which it reads nothing but [result], which the equations
   [inside] make of them; these are in an order in which they can be computed. *)
type cut = { group : Ir.signal list; result : Ir.signal; inside : Ir.equation list }

(* What a person would still give a name. *)
let largest = 8

let is_operation : Ir.rhs -> bool = function
  | Op _ | If _ -> true
  | Copy _ | Is_constructor _ | Payload _ | Construct _ | Elements _ | Absent | Fill _ | Index _
  | At _ | Replace _ | Delay _ | Time _ | Ticks _ | Integral _ | Derivative _ ->
      false

let among (signals : Ir.signal list) (s : Ir.signal) =
  List.exists (fun (other : Ir.signal) -> other.id = s.id) signals

(* By signal: the equations that make it of parameters and constants alone, itself last. *)
let made_of_parameters (node : Ir.node) =
  let made = Int_table.create 16 in
  List.iter (fun (s : Ir.signal) -> Int_table.replace made s.id []) node.statics;
  let join equations (s : Ir.signal) =
    let more = Int_table.find made s.id in
    equations @ List.filter (fun e -> not (List.memq e equations)) more
  in
  let make (e : Ir.equation) =
    let read = Operands.signals (Operands.all e.rhs) in
    let is_made (s : Ir.signal) = Int_table.find_opt made s.id <> None in
    if is_operation e.rhs && read <> [] && List.for_all is_made read then (
      let inside = List.fold_left join [] read @ [ e ] in
      if List.length inside <= largest then Int_table.replace made e.defines.id inside)
  in
  let order = List.filter_map (function Schedule.Equation e -> Some e | _ -> None) in
  let equations = order (Schedule.as_far_as_possible node) in
  List.iter make equations;
  List.filter_map
    (fun (e : Ir.equation) -> Option.map (fun inside -> (e.defines, inside)) (Int_table.find_opt made e.defines.id))
    equations

(* Nearest to the parameters first. *)
let cuts (node : Ir.node) =
  match if node.statics = [] then [] else made_of_parameters node with
  | [] -> []
  | made ->
      let uses = Uses.of_signals node in
      let cut ((result : Ir.signal), inside) =
        let read =
          List.concat_map (fun (e : Ir.equation) -> Operands.signals (Operands.all e.rhs)) inside
        in
        let group = List.filter (among read) node.statics in
        let between =
          List.filter_map
            (fun (e : Ir.equation) -> if e.defines.id = result.id then None else Some e.defines)
            inside
        in
        let only_inside (s : Ir.signal) =
          uses s = List.length (List.filter (fun (r : Ir.signal) -> r.id = s.id) read)
        in
        if List.for_all only_inside group && List.for_all only_inside between then
          Some { group; result; inside }
        else None
      in
      List.filter_map cut made

type work = { nodes : Ir.node array; mutable fresh : int; mutable changed : bool }

let fresh work =
  let id = work.fresh in
  work.fresh <- id + 1;
  id

(* What is passed for those parameters, of all of the callee's. *)
let passed (callee : Ir.node) group (t : Ir.transition) =
  List.concat
    (List.map2 (fun s a -> if among group s then [ (s, a) ] else []) callee.statics t.arguments)

(* The equations again, for what is passed, and the result. *)
let copies work cut passed =
  let atoms = Int_table.create 8 in
  List.iter (fun ((s : Ir.signal), a) -> Int_table.replace atoms s.id a) passed;
  let atom (a : Ir.atom) =
    match a with
    | Signal s -> Option.value (Int_table.find_opt atoms s.id) ~default:a
    | Bool _ | Int _ | Float _ -> a
  in
  let copy (e : Ir.equation) =
    let id = fresh work in
    let rhs = Operands.map atom e.rhs in
    let defines = { e.defines with id; group = id; name = "" } in
    Int_table.replace atoms e.defines.id (Ir.Signal defines);
    { e with defines; rhs }
  in
  let equations = List.map copy cut.inside in
  (equations, atom (Signal cut.result))

(* What the node computes for its transitions at every instant. *)
let for_transitions (node : Ir.node) =
  let definitions = Int_table.create 64 and found = Int_table.create 16 in
  List.iter (fun (e : Ir.equation) -> Int_table.replace definitions e.defines.id e.rhs) node.equations;
  let rec need (s : Ir.signal) =
    if not (Int_table.mem found s.id) then (
      Int_table.replace found s.id ();
      Option.iter
        (fun rhs -> List.iter need (Operands.signals (Operands.same_instant rhs)))
        (Int_table.find_opt definitions s.id))
  in
  List.iter need (Operands.signals (Transitions.atoms node.transitions));
  fun (s : Ir.signal) -> Int_table.mem found s.id

let with_equations (node : Ir.node) equations =
  { node with equations = node.equations @ equations }

type site =
  | Literals
  | There_anyhow
  | Handed_on  (** parameters that the caller reads for nothing else *)
  | Neither

let site work cut (callee : Ir.node) ~target (caller : Ir.node) t =
  let arguments t = passed callee cut.group t in
  let read = Operands.signals (List.map snd (arguments t)) in
  if read = [] then Literals
  else
    let before = work.fresh in
    let equations, result = copies work cut (arguments t) in
    work.fresh <- before;
    let equal = Share.equal (Parity.node (with_equations caller equations)) in
    match equal result with
    | Signal s when (not (List.exists (fun (e : Ir.equation) -> e.defines.id = s.id) equations))
                    && for_transitions caller s ->
        There_anyhow
    | _ ->
        let into_target =
          List.concat_map
            (fun (t : Ir.transition) ->
              if t.target = target then Operands.signals (List.map snd (arguments t)) else [])
            caller.transitions
        in
        let uses = Uses.of_signals caller in
        let is_handed_on (s : Ir.signal) =
          among caller.statics s
          && uses s = List.length (List.filter (fun (r : Ir.signal) -> r.id = s.id) into_target)
        in
        if List.compare_lengths read cut.group = 0 && List.for_all is_handed_on read then Handed_on
        else Neither

(* [hit.x] and [hit.y] are of a [hit]. *)
let name cut =
  let of_group (s : Ir.signal) = List.hd (String.split_on_char '.' s.name) in
  let names = List.sort_uniq String.compare (List.map of_group cut.group) in
  let operation (e : Ir.equation) =
    match e.rhs with Op (Elementary f, _) -> Some (Core.Primitive.name (Elementary f)) | _ -> None
  in
  match (cut.result.name, names, operation (List.nth cut.inside (List.length cut.inside - 1))) with
  | "", [ name ], Some f when name <> "" -> f ^ "_" ^ name
  | "", [ name ], None when name <> "" -> name ^ "_value"
  | name, _, _ -> name

let replace work cut ~mode ~target callers =
  let callee = work.nodes.(mode) in
  let id = fresh work in
  let by = { cut.result with id; group = id; name = name cut } in
  let first = List.hd cut.group in
  let replaced (s : Ir.signal) at_first other =
    if s.id = first.id then [ at_first ] else if among cut.group s then [] else [ other ]
  in
  let substitution = Substitution.create () in
  Substitution.replace substitution cut.result (Signal by);
  work.nodes.(mode) <-
    Substitution.node substitution
      {
        callee with
        statics = List.concat_map (fun s -> replaced s by s) callee.statics;
        equations = List.filter (fun e -> not (List.memq e cut.inside)) callee.equations;
      };
  let enter index =
    let caller = work.nodes.(index) in
    let added = ref [] in
    let transition (t : Ir.transition) =
      if t.target <> target then t
      else
        let equations, result = copies work cut (passed callee cut.group t) in
        added := !added @ equations;
        { t with arguments = List.concat (List.map2 (fun s a -> replaced s result a) callee.statics t.arguments) }
    in
    let transitions = List.map transition caller.transitions in
    work.nodes.(index) <-
      Share.node (Parity.node (with_equations { caller with transitions } !added))
  in
  List.iter enter callers;
  work.changed <- true

(* Of the machine's modes the one that is its [target], which these modes enter. *)
let rec of_mode work ~target mode callers =
  let is_into (t : Ir.transition) = t.target = target in
  let callee = work.nodes.(mode) in
  let is_worth_it cut =
    let sites =
      List.concat_map
        (fun index ->
          let caller = work.nodes.(index) in
          List.map (site work cut callee ~target caller) (List.filter is_into caller.transitions))
        callers
    in
    List.exists (fun site -> site <> Literals) sites
    && (not (List.mem Neither sites))
    && ((not (List.mem Handed_on sites)) || List.compare_length_with cut.group 2 >= 0)
  in
  match List.find_opt is_worth_it (cuts callee) with
  | Some cut ->
      replace work cut ~mode ~target callers;
      of_mode work ~target mode callers
  | None -> ()

(* By target the modes that enter it, each once. *)
let callers_in (nodes : Ir.node array) (machine : Ir.machine) =
  let callers = Array.make (List.length machine.modes) [] in
  let note index (t : Ir.transition) =
    match callers.(t.target) with
    | last :: _ when last = index -> ()
    | others -> callers.(t.target) <- index :: others
  in
  List.iter (fun index -> List.iter (note index) nodes.(index).transitions) machine.modes;
  callers

(* From mode to mode, as far as parameters are handed on. *)
let rounds = 8

let program (program : Ir.program) =
  let work =
    { nodes = Array.copy program.nodes; fresh = program.next_id; changed = false }
  in
  let machine (m : Ir.machine) =
    let callers = callers_in program.nodes m in
    let from_outside = Array.make (Array.length callers) false in
    List.iter (fun (t : Ir.transition) -> from_outside.(t.target) <- true) (m.start @ m.controls);
    let rec again round =
      work.changed <- false;
      List.iteri
        (fun target mode ->
          if not from_outside.(target) then of_mode work ~target mode callers.(target))
        m.modes;
      if work.changed && round < rounds then again (round + 1)
    in
    again 1
  in
  Array.iter (fun (node : Ir.node) -> Option.iter machine node.machine) program.nodes;
  if Array.for_all2 ( == ) work.nodes program.nodes then program else { program with nodes = work.nodes; next_id = work.fresh }
