type use = { ends : bool; drops : bool }

let is (s : Ir.signal) (atom : Ir.atom) =
  match atom with Signal other -> other.id = s.id | Bool _ | Int _ | Float _ -> false

(* Does one of its transitions surely occur where all of these Bools are true? *)
let is_left (user : Ir.node) (signals : Ir.signal list) =
  signals <> [] && user.transitions <> []
  &&
  let known = Truth.at_an_instant user (List.map (fun s -> (s, true)) signals) in
  List.exists (fun (t : Ir.transition) -> Truth.value known t.occurs = Some true) user.transitions

let use_by (node : Ir.node) ((user : Ir.node), (i : Ir.instance)) (output : Ir.signal) =
  (* Of the instance's outputs those that are this one of the machine. *)
  let given =
    List.concat
      (List.map2 (fun s (_, atom) -> if is output atom then [ s ] else []) i.outputs node.outputs)
  in
  let uses = Uses.of_signals user in
  let put_out s = List.length (List.filter (fun (_, atom) -> is s atom) user.outputs) in
  {
    ends = output.ty = Bool && is_left user given;
    drops =
      Uses.of_signals node output = List.length given
      && List.for_all (fun s -> uses s = put_out s) given
      && not (List.exists (fun (t : Ir.transition) -> t.delayed) user.transitions);
  }

(* By node: who runs it, unless a loop or a trial does. *)
let users (program : Ir.program) =
  let users = Array.make (Array.length program.nodes) (Some []) in
  let note (user : Ir.node) (i : Ir.instance) =
    let add others =
      if Option.is_none i.loop && i.trials = [] then Some ((user, i) :: others) else None
    in
    users.(i.node) <- Option.bind users.(i.node) add
  in
  Array.iter (fun (user : Ir.node) -> List.iter (note user) user.instances) program.nodes;
  users

let both a b = { ends = a.ends && b.ends; drops = a.drops && b.drops }

let of_node (node : Ir.node) users =
  match (node.machine, users) with
  | Some machine, Some (first :: others) ->
      let by user = List.map (use_by node user) machine.outputs in
      List.fold_left (fun uses user -> List.map2 both uses (by user)) (by first) others
  | (Some _ | None), _ -> []

let uses program =
  let users = users program in
  fun index -> of_node program.nodes.(index) users.(index)

let outputs (program : Ir.program) =
  let found = Array.make (Array.length program.nodes) None in
  let uses = uses program in
  let number uses =
    let numbered = List.mapi (fun k use -> (k, use)) uses in
    let all_dropped_but k = List.for_all (fun (other, use) -> other = k || use.drops) numbered in
    List.find_map (fun (k, use) -> if use.ends && all_dropped_but k then Some k else None) numbered
  in
  Array.iteri
    (fun index (node : Ir.node) ->
      match node.machine with
      | Some { active = None; modes; _ } ->
          let number = number (uses index) in
          List.iter (fun mode -> found.(mode) <- number) modes
      | Some { active = Some _; _ } | None -> ())
    program.nodes;
  found
