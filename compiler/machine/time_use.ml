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

let nanoseconds_in_floats (program : Ir.program) (node : Ir.node) =
  let has_own_instants = ref false in
  Walk.statements
    (function
      | Ir.Run { clock = Some _; _ } -> has_own_instants := true
      | Run { clock = None; _ } | Declare _ | Assign _ | If _ | Step _ | Loop _ | Reset _ | Enter _
      | Start _ | Begin _ | Await _ | Return _ -> ())
    node.step.body;
  program.real = Double && node.modes <> [] && not !has_own_instants

let divides (program : Ir.program) =
  let found = ref false in
  let divides_by_time = function
    | Ir.Operation { operator = Divide; arguments = [ _; Dt ]; _ } -> found := true
    | _ -> ()
  in
  Array.iter (fun (node : Ir.node) -> Walk.expressions divides_by_time node.step.body) program.nodes;
  !found
