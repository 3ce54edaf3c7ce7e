open Basis

type t = {
  at_reset : Flow.Schedule.item list;
  kept : Flow.Ir.signal list;
  in_step : Flow.Schedule.item list;
  read_by_step : Flow.Ir.signal list;
}

type cost = Cheap | Costly

let is_expensive = function Flow.Ir.Op ((Pow | Elementary _), _) -> true | _ -> false

(* The state of the analysis of a node; tables are indexed by signal id. *)
type work = {
  program : Flow.Ir.program;
  static : cost Int_table.t;
  definer : Flow.Schedule.item Int_table.t;
}

let is_static work = function
  | Flow.Ir.Signal s -> Int_table.mem work.static s.id
  | Bool _ | Int _ | Float _ -> true

let cost_of_operands work atoms =
  let is_costly = function
    | Flow.Ir.Signal s -> Int_table.find_opt work.static s.id = Some Costly
    | Bool _ | Int _ | Float _ -> false
  in
  if List.exists is_costly atoms then Costly else Cheap

(* Whether the signal's value stays valid after the instant. Values whose memory C owns become
   invalid, so they must be computed in each instant. *)
let lasts work (s : Flow.Ir.signal) =
  Option.is_none (Flow.Shape.of_the_instant work.program.sums s.ty)

(* Classifies an item. All items that it depends on must have been classified already. *)
let classify work item =
  List.iter
    (fun (s : Flow.Ir.signal) -> Int_table.replace work.definer s.id item)
    (Flow.Schedule.defines item);
  match item with
  | Flow.Schedule.Equation e ->
      let operands = Flow.Operands.all e.rhs in
      if (not (Flow.Rhs.is_stateful e.rhs)) && List.for_all (is_static work) operands then
        Int_table.replace work.static e.defines.id
          (if is_expensive e.rhs then Costly else cost_of_operands work operands)
  | Instance i ->
      if
        work.program.nodes.(i.node).kind = Function
        && List.for_all (is_static work) i.statics
        && List.for_all (is_static work) i.inputs
        && List.for_all (lasts work) i.outputs
      then
        let costly (s : Flow.Ir.signal) = Int_table.replace work.static s.id Costly in
        List.iter costly i.outputs
  | Trial _ | Machine _ -> ()

let operands_of_item = function
  | Flow.Schedule.Equation e -> Flow.Operands.all e.rhs
  | Instance i -> List.rev_append i.statics i.inputs
  | Trial (i, trial) -> List.rev_append i.statics (List.filter_map Fun.id trial.given)
  | Machine m -> Flow.Transitions.read_in_step m

(* The signals from which [roots] are computed through static definitions, including the roots. The
   search stops at signals that satisfy [stop]. *)
let closure work ~stop roots =
  let seen = Int_table.create 16 in
  let rec walk = function
    | [] -> seen
    | (s : Flow.Ir.signal) :: rest when Int_table.mem seen s.id -> walk rest
    | s :: rest ->
        Int_table.replace seen s.id ();
        if stop s then walk rest
        else
          let operands =
            match Int_table.find_opt work.definer s.id with
            | Some item -> Flow.Operands.signals (operands_of_item item)
            | None -> []
          in
          walk (List.rev_append operands rest)
  in
  walk roots

let defines_one_of table item =
  List.exists (fun (s : Flow.Ir.signal) -> Int_table.mem table s.id) (Flow.Schedule.defines item)

(* The atoms that a dynamic item reads when it starts, and in each step. *)
let read_at_start (program : Flow.Ir.program) = function
  | Flow.Schedule.Equation { rhs = Delay { init; _ }; _ } -> [ init ]
  | Equation _ -> []
  | Instance i -> (
      match program.nodes.(i.node).kind with Signal_function -> i.statics | Function -> [])
  | Trial _ -> []
  | Machine m -> Flow.Transitions.atoms m.start

let read_in_step (program : Flow.Ir.program) (callee : int -> t) = function
  | Flow.Schedule.Equation { rhs = Delay { next; _ }; _ } -> [ next ]
  | Equation e -> Flow.Operands.all e.rhs
  | Instance i ->
      let node = program.nodes.(i.node) in
      let read = (callee i.node).read_by_step in
      let is_read (s : Flow.Ir.signal) =
        List.exists (fun (r : Flow.Ir.signal) -> r.id = s.id) read
      in
      let add all parameter atom = if is_read parameter then atom :: all else all in
      List.fold_left2 add i.inputs node.statics i.statics
  | Trial (_, trial) -> List.filter_map Fun.id trial.given
  | Machine m -> Flow.Transitions.read_in_step m

let of_function (node : Flow.Ir.node) =
  { at_reset = []; kept = []; in_step = Flow.Schedule.of_node node; read_by_step = node.statics }

let of_signal_function (program : Flow.Ir.program) callee (node : Flow.Ir.node) =
  let work = { program; static = Int_table.create 64; definer = Int_table.create 64 } in
  List.iter (fun (s : Flow.Ir.signal) -> Int_table.replace work.static s.id Cheap) node.statics;
  let items = Flow.Schedule.of_node node in
  List.iter (classify work) items;
  let is_static_item = function
    | Flow.Schedule.Equation e -> Int_table.mem work.static e.defines.id
    | Instance i -> ( match i.outputs with s :: _ -> Int_table.mem work.static s.id | [] -> false)
    | Trial _ | Machine _ -> false
  in
  let static_items, dynamic = List.partition is_static_item items in
  let gather read = List.fold_left (fun all item -> List.rev_append (read item) all) [] dynamic in
  let at_start = gather (read_at_start program) in
  List.iter
    (fun atom ->
      if not (is_static work atom) then
        Diagnostic.bug ~stage:"Step.Statics" "an initial value or a parameter in `%s` is not static"
          node.name)
    at_start;
  let outputs =
    List.rev_append (Flow.Transitions.atoms node.transitions) (List.rev_map snd node.outputs)
  in
  let static_only = List.filter (fun (s : Flow.Ir.signal) -> Int_table.mem work.static s.id) in
  let read = gather (read_in_step program callee) in
  let in_step = static_only (Flow.Operands.signals (List.rev_append outputs read)) in
  let is_costly (s : Flow.Ir.signal) = Int_table.find_opt work.static s.id = Some Costly in
  (* A cheap static value depends only on other cheap ones, so the search stops at values that are
     stored. *)
  let needed_in_step = closure work ~stop:is_costly in_step in
  let kept =
    List.concat_map
      (fun item ->
        List.filter
          (fun (s : Flow.Ir.signal) -> is_costly s && Int_table.mem needed_in_step s.id)
          (Flow.Schedule.defines item))
      static_items
  in
  let at_reset_roots = List.rev_append (Flow.Operands.signals at_start) kept in
  let needed_at_reset = closure work ~stop:(fun _ -> false) at_reset_roots in
  let is_kept = Int_table.create 16 in
  List.iter (fun (s : Flow.Ir.signal) -> Int_table.replace is_kept s.id ()) kept;
  let runs_in_step item =
    (not (is_static_item item))
    || (defines_one_of needed_in_step item && not (defines_one_of is_kept item))
  in
  {
    at_reset = List.filter (defines_one_of needed_at_reset) static_items;
    kept;
    in_step = List.filter runs_in_step items;
    read_by_step =
      List.filter (fun (s : Flow.Ir.signal) -> Int_table.mem needed_in_step s.id) node.statics;
  }

let program (program : Flow.Ir.program) =
  let node ~before _ (node : Flow.Ir.node) =
    match node.kind with
    | Function -> of_function node
    | Signal_function -> of_signal_function program before node
  in
  In_order.map ~stage:"Step.Statics" node program.nodes

let equations_in_step statics =
  List.filter_map
    (function Flow.Schedule.Equation eq -> Some eq | Instance _ | Trial _ | Machine _ -> None)
    statics.in_step
