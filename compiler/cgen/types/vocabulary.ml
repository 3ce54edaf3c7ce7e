open Program_names
module F = Flow.Ir
module M = Step.Ir

(* The collected struct types of the program's interface. *)
type structs = {
  source : M.program;
  units : Units.t;
  own : Interface.types;
  shared : Interface.types;  (** the types of robots and foreign code *)
}

let is_root t k = k = Array.length t.program.nodes - 1

let has_modes t =
  Array.exists
    (fun (node : M.node) -> match node.modes with [] | [ _ ] -> false | _ :: _ :: _ -> true)
    t.program.nodes

let has_state t k = match t.program.nodes.(k).state with [] -> false | _ :: _ -> true
let home t k = Step.State_struct.home t.structs k
let state_struct t k = t.nodes.(home t k).state

(* Names modes after their definitions. *)
let name_modes (nodes : M.node array) scope ~prefix (node : M.node) =
  let modes = Name.scope Members in
  let constant name =
    Name.fresh scope (String.uppercase_ascii (Name.identifier (prefix ^ "_" ^ Name.snake name)))
  in
  let name (mode : M.mode) =
    let member = Name.fresh modes nodes.(mode.node).origin in
    let constant = match node.modes with [] | [ _ ] -> "" | _ :: _ :: _ -> constant member in
    { constant; member }
  in
  Array.of_list (List.map name node.modes)

(* Names the members of a struct, and stores the paths to the fields. [within]: the path to the
   struct, in reverse order. *)
let rec name_members (nodes : node array) ~within members =
  let scope = Name.scope Members in
  let name (stores : Step.State_struct.member) =
    let name = Name.fresh scope (String.concat "_" stores.path) in
    let path = name :: within in
    let node = nodes.(stores.node) in
    let mode (number, members) =
      let mode = node.modes.(number).member in
      (mode, name_members nodes ~within:(mode :: path) members)
    in
    match stores.field.content with
    | Modes _ -> { name; stores; modes = List.map mode stores.modes }
    | Value _ | State_of _ | States_of _ | Running_mode | Component _ ->
        Basis.Int_table.replace node.paths stores.field.id (List.rev path);
        { name; stores; modes = [] }
  in
  Basis.Long_list.map name members

type root = {
  root_state : string;
  root_reset : string;
  root_step : string;
  root_in_seconds : string;
  root_is_valid : string;
}

let name_root scope ~name =
  let take suffix = Name.fresh scope (name ^ suffix) in
  let root_state = take "_state" in
  let root_reset = take "_reset" in
  let root_in_seconds = take "_step" in
  let root_step = take "_step_ns" in
  let root_is_valid = take "_is_valid" in
  { root_state; root_reset; root_step; root_in_seconds; root_is_valid }

let name_nodes scope ~name ~root ~foreign ~structs (nodes : M.node array) =
  let last = Array.length nodes - 1 in
  let name_node k (node : M.node) =
    let own = name ^ "_" ^ node.name in
    let prefix = if k = last then name else own in
    let modes = name_modes nodes scope ~prefix node in
    let names ~state ~reset ~step =
      let paths = Basis.Int_table.create 16 in
      { state; reset; step; members = []; paths; modes; foreign = foreign.(k) }
    in
    if k = last then names ~state:root.root_state ~reset:root.root_reset ~step:root.root_step
    else
      match (node.state, node.foreign) with
      | [], _ -> names ~state:"" ~reset:"" ~step:(Name.fresh scope own)
      | _ :: _, Some { import = { symbol; _ }; _ } ->
          names ~state:(Foreign_interface.state symbol) ~reset:(Foreign_interface.reset symbol)
            ~step:(Name.fresh scope (own ^ "_step"))
      | _ :: _, None ->
          let is_home = Step.State_struct.home structs k = k in
          let state = if is_home then Name.fresh scope (own ^ "_state") else "" in
          let reset = Name.fresh scope (own ^ "_reset") in
          let step = Name.fresh scope (own ^ "_step") in
          names ~state ~reset ~step
  in
  let named = Array.mapi name_node nodes in
  let with_members k node =
    { node with members = name_members named ~within:[] (Step.State_struct.members structs k) }
  in
  Array.mapi with_members named

(* The names of the user's C functions and types. *)
let foreign_names (program : M.program) =
  let names (f : F.import) =
    match f.kind with
    | Function -> [ f.symbol ]
    | Signal_function ->
        List.map (( ^ ) f.symbol) [ "_state"; "_input"; "_output"; "_reset"; "_step" ]
  in
  List.concat_map names program.imports

(* The interfaces of the user's C functions and, for each node, the interface of the function that
   it calls. *)
let foreign_interfaces scope shared (program : M.program) =
  let fresh = Name.fresh scope in
  let imports = List.map (Foreign_interface.of_import shared ~fresh) program.imports in
  let interface_of (f : F.foreign) =
    List.find (fun (i : Foreign_interface.t) -> String.equal i.symbol f.import.symbol) imports
  in
  (imports, Array.map (fun (node : M.node) -> Option.map interface_of node.foreign) program.nodes)

(* The parts of the program's input and output that belong to robots, each with its robot. *)
type parts = {
  sensed : F.shape;
  console : Robot.console option;
  input_robot : Robot.t option;
  command : F.shape;
  result : F.shape option;
  output_robot : Robot.t option;
}

let parts_of_robots ?own known (program : M.program) =
  (* Robots' structs contain doubles. In single precision, the program's own structs differ from
     them, and the table for hosts converts between the two. The robot then matters only if the
     program imports C code, which may use the robot's types. *)
  let robot_of shape =
    match (program.real, program.imports) with
    | Single, [] -> None
    | Double, _ | Single, _ :: _ ->
        let robot = Robot.of_shape ?own shape in
        if Option.is_some robot then Value_types.mark known Robot shape;
        robot
  in
  let command, result =
    if program.ends then Interface.apart program.output else (program.output, None)
  in
  let sensed, console =
    match Robot.of_shape ?own program.input with
    | Some _ -> Robot.apart program.input
    | None -> (program.input, None)
  in
  let input_robot = robot_of sensed in
  let output_robot = robot_of command in
  { sensed; console; input_robot; command; result; output_robot }

(* The struct of a value, part of which may belong to a robot. [whole] is the shape of the value,
   and [part] is the shape of the robot's part. *)
let interface (structs : structs) robot ~name ~units ~whole ~(part : F.shape) result =
  let robots =
    match (robot, part) with
    | Some _, Product product ->
        let name = "frob_" ^ Name.snake product.product_name in
        Some (Interface.of_record structs.shared ~name product)
    | _, _ -> None
  in
  match (structs.source.real, robots, result) with
  | Double, Some robots, None -> robots
  | Double, Some robots, Some result ->
      Interface.with_others structs.own ~name ~first:"command" robots [ ("result", result) ]
  | Double, None, _ | Single, _, _ -> Interface.of_shape structs.own ~units ~name whole

let input_interface (structs : structs) ~name { input_robot = robot; sensed; console; _ } =
  let whole = structs.source.input in
  let plain = interface structs robot ~name ~units:structs.units.input ~whole ~part:sensed None in
  match (structs.source.real, robot, console) with
  | Double, Some _, Some { part; at } ->
      Interface.with_others structs.own ~name ~first:"robot" plain [ part ]
      |> Interface.with_leaves ~at (List.length (Flow.Shape.leaves (snd part)))
  | _, _, _ -> plain

let output_interface (structs : structs) ~fresh ~name { output_robot = robot; command; result; _ } =
  let output name =
    let whole = structs.source.output in
    interface structs robot ~name ~units:structs.units.output ~whole ~part:command result
  in
  match structs.source.probes with
  | [] -> output name
  | probes ->
      let plain = output (fresh (Name.identifier structs.source.name ^ "_command")) in
      let probes = [ ("probes", Interface.record_of probes) ] in
      Interface.with_others structs.own ~name ~first:"command" plain probes

let of_program ?own ?(units = Units.none) ?(named = Named_constants.none) (program : M.program) =
  let name = Name.identifier program.name in
  let scope = Name.scope Identifiers ~taken:(foreign_names program @ Helpers.names ()) in
  let input_name = Name.fresh scope (name ^ "_input") in
  let output_name = Name.fresh scope (name ^ "_output") in
  (* Names that hosts and users see are chosen first, so that no internal name takes them: the root
     gets the program's own names, and its types are named before internal functions. *)
  let root = name_root scope ~name in
  let params = Param_struct.of_program scope ~name program in
  let known = Value_types.known program.sums in
  let parts = parts_of_robots ?own known program in
  List.iter
    (fun (f : F.import) ->
      List.iter (Value_types.mark known Foreign_code) (f.result :: f.arguments))
    program.imports;
  let types = Value_types.own scope ~name ~real:program.real known in
  let foreign_types = Value_types.of_foreign_code types in
  let interface_types types ~real ~prefix =
    let sum k = (Value_types.sums types).(k).struct_name in
    Interface.types scope ~real ~prefix ~sum ~foreign:Value_types.foreign_type ~units
  in
  let own = interface_types types ~real:program.real ~prefix:name in
  let shared = interface_types foreign_types ~real:Double ~prefix:"frob" in
  let structs = { source = program; units; own; shared } in
  let input = input_interface structs ~name:input_name parts in
  let output = output_interface structs ~fresh:(Name.fresh scope) ~name:output_name parts in
  let robot_records = Interface.definitions shared in
  let imports, foreign = foreign_interfaces scope shared program in
  let is_robots d = List.memq d robot_records in
  let foreign_records = List.filter (fun d -> not (is_robots d)) (Interface.definitions shared) in
  let layout = Step.State_struct.of_program program in
  let nodes = name_nodes scope ~name ~root ~foreign ~structs:layout program.nodes in
  {
    program;
    structs = layout;
    units;
    named;
    name;
    file_scope = scope;
    types;
    foreign_types;
    sums = Value_types.sums types;
    nodes;
    in_seconds = root.root_in_seconds;
    is_valid = root.root_is_valid;
    input;
    output;
    params;
    param_use = Step.Param_use.of_program program;
    dt_limits = Step.Dt_limits.of_program program;
    by_pointer = Program_input.of_program program input;
    records = Interface.definitions own;
    robot_records;
    foreign_records;
    imports;
    robots =
      List.sort_uniq compare (List.filter_map Fun.id [ parts.input_robot; parts.output_robot ]);
    helpers = Hashtbl.create 16;
    pending = [];
    absent = Hashtbl.create 4;
    constants = Hashtbl.create 8;
  }

let real t = Ir.Real t.program.real
let ty t = Value_types.ty t.types

let absent t (ty : F.foreign_type) : Ir.expr =
  if not ty.copyable then Integer 0l
  else
    match Hashtbl.find_opt t.absent ty with
    | Some name -> Name name
    | None ->
        let name = Name.fresh t.file_scope (t.name ^ "_no_" ^ Name.snake ty.foreign_name) in
        Hashtbl.replace t.absent ty name;
        Name name

let zero t ty = Sum_type.zero t.program.real t.program.sums ~absent:(absent t) ty
let in_precision t name = name ^ Print.real_suffix t.program.real
let call t name arguments = Ir.Call (in_precision t name, arguments)
let is_negative_zero x = Float.equal x 0. && Float.sign_bit x

let float t x =
  if is_negative_zero x then call t "frob_negative_zero" [] else Ir.Float (t.program.real, x)

let named t (constant : Named_constants.constant) x =
  match Hashtbl.find_opt t.constants constant with
  | Some (name, _) -> name
  | None ->
      let name = Name.fresh t.file_scope (t.name ^ "_" ^ Name.snake constant.name) in
      Hashtbl.replace t.constants constant (name, x);
      name

let literal t ~at x =
  match t.named ~at x with Some constant -> Ir.Name (named t constant x) | None -> float t x

let elementary (f : Core.Primitive.elementary) =
  match f with
  | Sqrt -> "sqrt"
  | Floor_float -> "floor"
  | Ceiling_float -> "ceil"
  | Nanoseconds -> "frob_nanoseconds"
  | Hypot | Exp | Log | Sin | Cos | Tan | Asin | Acos | Atan | Atan2 ->
      "frob_" ^ Core.Primitive_table.name (Elementary f)

(* A helper is generated when it is first called. *)
let helper t key make =
  match Hashtbl.find_opt t.helpers key with
  | Some name -> name
  | None ->
      let function_ : Ir.function_ = make () in
      Hashtbl.replace t.helpers key function_.name;
      t.pending <- function_ :: t.pending;
      function_.name

let maker t ~sum ~constructor =
  helper t
    (Maker { sum; constructor })
    (fun () -> Sum_type.maker t.program.sums ~absent:(absent t) t.sums sum constructor)

let projection t ~sum ~constructor ~leaf =
  helper t
    (Projection { sum; constructor; leaf })
    (fun () -> Sum_type.projection t.program.sums t.sums sum ~constructor ~leaf)

let array_function t operation (array : M.ty) =
  match array with
  | Array (count, element) ->
      helper t
        (On_arrays (operation, array))
        (fun () ->
          let struct_name = Value_types.array_name t.types array in
          let suffix = "_" ^ Array_type.suffix operation in
          let name = Name.fresh t.file_scope (struct_name ^ suffix) in
          Array_type.function_ operation name ~struct_name ~count ~element:(ty t element))
  | Bool | Int | Float | Nanoseconds | Sum _ | Foreign _ ->
      Basis.Diagnostic.bug ~stage:"Cgen.Vocabulary" "expected an array type"

let take_pending t =
  let all = List.rev t.pending in
  t.pending <- [];
  all
