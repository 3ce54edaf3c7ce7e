open Basis

let check_node (program : Ir.program) (node : Ir.node) =
  let static = Int_table.create 64 in
  let add (s : Ir.signal) = Int_table.replace static s.id () in
  let is_static : Ir.atom -> bool = function
    | Signal s -> Int_table.mem static s.id
    | Bool _ | Int _ | Float _ -> true
  in
  let is_function (i : Ir.instance) = program.nodes.(i.node).kind = Function in
  let classify = function
    | Schedule.Equation e ->
        if (not (Rhs.is_stateful e.rhs)) && List.for_all is_static (Operands.all e.rhs) then
          add e.defines
    | Instance i ->
        if is_function i && List.for_all is_static i.statics && List.for_all is_static i.inputs then
          List.iter add i.outputs
    | Trial _ | Machine _ -> ()
  in
  let expect what a =
    if not (is_static a) then
      Diagnostic.bug ~stage:"Flow.Initialization" "%s in `%s` is not static" what node.name
  in
  List.iter add node.statics;
  List.iter classify (Schedule.as_far_as_possible node);
  List.iter
    (fun (e : Ir.equation) ->
      match e.rhs with
      | Delay { init; next = _ } -> expect "an initial value" init
      | Ticks period -> expect "a period" period
      | _ -> ())
    node.equations;
  List.iter
    (fun (i : Ir.instance) ->
      let what = "a start value of `" ^ i.name ^ "`" in
      if not (is_function i) then List.iter (expect what) i.statics)
    node.instances;
  Option.iter
    (fun (m : Ir.machine) ->
      List.iter (expect "a start value of the first mode") (Transitions.atoms m.start))
    node.machine

let check (program : Ir.program) = Array.iter (check_node program) program.nodes
