let by_one_mode (program : Ir.program) (node : Ir.node) =
  let wanted index = program.nodes.(index).Ir.seconds in
  let elsewhere = ref false in
  Walk.expressions (function Ir.Dt -> elsewhere := true | _ -> ()) node.step.body;
  Walk.statements
    (function
      | Ir.Step { node; _ } | Loop { node; _ } -> if wanted node then elsewhere := true
      | Run { clock = Some _; _ } -> elsewhere := true
      | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Start _ | Begin _ | Await _
      | Run { clock = None; _ } | Return _ -> ())
    node.step.body;
  (not !elsewhere)
  && List.length node.modes > 1
  && List.length (List.filter (fun (mode : Ir.mode) -> wanted mode.node) node.modes) = 1

type modes =
  | In of int list
  | Not_in of int list

let most_compared = 2

let only_in_modes (program : Ir.program) (node : Ir.node) =
  let looks index = program.nodes.(index).Ir.seconds || program.nodes.(index).nanoseconds in
  let elsewhere = ref false in
  Walk.expressions (function Ir.Dt | Dt_nanoseconds -> elsewhere := true | _ -> ()) node.step.body;
  Walk.statements
    (function
      | Ir.Step { node; _ } | Loop { node; _ } -> if looks node then elsewhere := true
      | Run ({ clock; controls; _ } as run) ->
          if Option.is_some clock || controls <> [] || not (Direct.is_direct run) then elsewhere := true
      | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Start _ | Begin _ | Await _ | Return _ -> ())
    node.step.body;
  let numbered = List.mapi (fun number (mode : Ir.mode) -> (number, looks mode.node)) node.modes in
  let looking, others = List.partition snd numbered in
  let few modes = List.compare_length_with modes most_compared <= 0 in
  let numbers = List.map fst in
  let at_once = node.seconds && not (by_one_mode program node) in
  let one = List.compare_length_with looking 1 <= 0 in
  if program.real <> Double || !elsewhere || at_once || one || others = [] then None
  else if List.compare_lengths others looking < 0 && few others then Some (Not_in (numbers others))
  else if few looking then Some (In (numbers looking))
  else None

let steps_elsewhere (program : Ir.program) k =
  let found = ref false in
  let code (code : Ir.code) =
    Walk.statements
      (function
        | Ir.Step { node; _ } | Loop { node; _ } -> if node = k then found := true
        | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Start _ | Begin _ | Await _ | Run _
        | Return _ -> ())
      code.body
  in
  let root = Array.length program.nodes - 1 in
  Array.iteri
    (fun other (node : Ir.node) ->
      if other <> root && List.exists (fun (mode : Ir.mode) -> mode.node = k) node.modes then
        found := true;
      List.iter code (node.reset :: node.step :: Option.to_list node.start))
    program.nodes;
  !found

let rounded_by_modes (program : Ir.program) =
  let root = program.nodes.(Array.length program.nodes - 1) in
  let zero_at_first =
    match program.first_instant with
    | Marked_by _ -> true
    | Unseen | Apart | Marked_by_mode -> false
  in
  match only_in_modes program root with
  | Some (In numbers) when not (root.seconds || zero_at_first) ->
      let nodes = List.map (fun number -> (List.nth root.modes number).Ir.node) numbers in
      let may k = Option.is_none program.nodes.(k).foreign && not (steps_elsewhere program k) in
      if List.for_all may nodes then List.sort_uniq Int.compare nodes else []
  | Some (In _ | Not_in _) | None -> []

let nanoseconds_in_floats (program : Ir.program) (node : Ir.node) =
  let has_own_instants = ref false in
  Walk.statements
    (function
      | Ir.Run { clock = Some _; _ } -> has_own_instants := true
      | Run { clock = None; _ } | Declare _ | Assign _ | If _ | Step _ | Loop _ | Reset _ | Enter _
      | Start _ | Begin _ | Await _ | Return _ -> ())
    node.step.body;
  let in_some_modes = (not node.seconds) && Option.is_some (only_in_modes program node) in
  program.real = Double && node.modes <> [] && (not !has_own_instants) && not in_some_modes

let divides (program : Ir.program) =
  let found = ref false in
  let divides_by_time = function
    | Ir.Operation { operator = Divide; arguments = [ _; Dt ]; _ } -> found := true
    | _ -> ()
  in
  Array.iter (fun (node : Ir.node) -> Walk.expressions divides_by_time node.step.body) program.nodes;
  !found
