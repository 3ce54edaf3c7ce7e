module F = Flow.Ir
module M = Machine.Ir

type mode = { constant : string; member : string }

type node = {
  state : string;
  reset : string;
  step : string;
  members : (int, string list) Hashtbl.t;
  modes : mode array;
}

type t = {
  program : M.program;
  name : string;
  file_scope : Name.scope;
  sums : Sum_type.t array;
  foreign : bool array;
  nodes : node array;
  input : Interface.t;
  output : Interface.t;
  records : Ir.declaration list;
  robot_records : Ir.declaration list;
  robots : Robot.t list;
  helpers : (Helper.t, unit) Hashtbl.t;
  makers : (int * int, unit) Hashtbl.t;
  projections : (int * int * int, unit) Hashtbl.t;
}

let is_root t k = k = Array.length t.program.nodes - 1
let has_state t k = match t.program.nodes.(k).state with [] -> false | _ :: _ -> true

(* The members of a struct with these fields, each after [path]. *)
let name_members table path fields =
  let scope = Name.scope Members in
  List.iter
    (fun (field : M.field) ->
      Hashtbl.replace table field.id (List.rev (Name.fresh scope field.name :: path)))
    fields

(* Modes are named after their definitions. *)
let name_modes (nodes : M.node array) table scope ~prefix (node : M.node) =
  let modes = Name.scope Members in
  let room =
    List.find_map
      (fun (field : M.field) ->
        match field.content with
        | Modes _ -> Some (Hashtbl.find table field.id)
        | Value _ | State_of _ | Running_mode -> None)
      node.state
  in
  let name (mode : M.mode) =
    let definition = nodes.(mode.node).origin in
    let member = Name.fresh modes definition in
    let path = member :: List.rev (Option.value room ~default:[]) in
    name_members table path (Machine.State.fields_of_mode mode);
    let constant =
      match node.modes with
      | [] | [ _ ] -> ""
      | _ :: _ :: _ ->
          Name.fresh scope (String.uppercase_ascii (Name.identifier (prefix ^ "_" ^ Name.snake member)))
    in
    { constant; member }
  in
  Array.of_list (List.map name node.modes)

let members scope ~prefix nodes (node : M.node) =
  let table = Hashtbl.create 16 in
  name_members table [] node.state;
  let modes = name_modes nodes table scope ~prefix node in
  (table, modes)

type root = { root_state : string; root_reset : string; root_step : string }

let name_root scope ~name =
  let take suffix = Name.fresh scope (name ^ suffix) in
  let root_state = take "_state" in
  let root_reset = take "_reset" in
  { root_state; root_reset; root_step = take "_step" }

let name_nodes scope ~name ~root (nodes : M.node array) =
  let last = Array.length nodes - 1 in
  Array.mapi
    (fun k (node : M.node) ->
      let own = name ^ "_" ^ node.name in
      let prefix = if k = last then name else own in
      let members, modes = members scope ~prefix nodes node in
      if k = last then
        { state = root.root_state; reset = root.root_reset; step = root.root_step; members; modes }
      else
        match node.state with
        | [] -> { state = ""; reset = ""; step = Name.fresh scope own; members; modes }
        | _ :: _ ->
            let state = Name.fresh scope (own ^ "_state") in
            let reset = Name.fresh scope (own ^ "_reset") in
            { state; reset; step = Name.fresh scope (own ^ "_step"); members; modes })
    nodes

let of_program (program : M.program) =
  let name = Name.identifier program.name in
  let scope = Name.scope Identifiers ~taken:Helper.names in
  let input_name = Name.fresh scope (name ^ "_input") in
  let output_name = Name.fresh scope (name ^ "_output") in
  (* What a host calls and sees has the first choice: the root's names are the
     program's own, its types come before the functions inside. *)
  let root = name_root scope ~name in
  let foreign = Array.make (Array.length program.sums) false in
  let robot_of shape =
    let robot = Robot.of_shape shape in
    let mark (ty : F.ty) =
      match ty with Sum k -> foreign.(k) <- true | Bool | Int | Float -> ()
    in
    if Option.is_some robot then List.iter mark (Machine.Layout.shape_leaves shape);
    robot
  in
  let input_robot = robot_of program.input in
  let output_robot = robot_of program.output in
  let sums =
    Array.mapi
      (fun k sum ->
        let prefix = if foreign.(k) then "frob" else name in
        Sum_type.name scope ~prefix sum ~slots:(Machine.Layout.sum program.sums k))
      program.sums
  in
  let sum k = sums.(k).struct_name in
  let own = Interface.types scope ~prefix:name ~sum in
  let robots = Interface.types scope ~prefix:"frob" ~sum in
  let interface robot struct_name (shape : F.shape) =
    match (robot, shape) with
    | Some _, Product { product_name; _ } ->
        Interface.of_shape robots ~name:("frob_" ^ Name.snake product_name) shape
    | _, _ -> Interface.of_shape own ~name:struct_name shape
  in
  let input = interface input_robot input_name program.input in
  let output = interface output_robot output_name program.output in
  let nodes = name_nodes scope ~name ~root program.nodes in
  {
    program;
    name;
    file_scope = scope;
    sums;
    foreign;
    nodes;
    input;
    output;
    records = Interface.definitions own;
    robot_records = Interface.definitions robots;
    robots =
      List.sort_uniq compare (List.filter_map Fun.id [ input_robot; output_robot ]);
    helpers = Hashtbl.create 16;
    makers = Hashtbl.create 16;
    projections = Hashtbl.create 16;
  }

let ty t : M.ty -> Ir.ty = function
  | Bool -> Bool
  | Int -> Int32
  | Float -> Real
  | Nanoseconds -> Int64
  | Sum k -> Struct t.sums.(k).struct_name

let helper t helper =
  Hashtbl.replace t.helpers helper ();
  Helper.name helper

let maker t ~sum ~constructor =
  Hashtbl.replace t.makers (sum, constructor) ();
  t.sums.(sum).makers.(constructor)

let projection t ~sum ~constructor ~leaf =
  Hashtbl.replace t.projections (sum, constructor, leaf) ();
  Sum_type.projection_name t.sums.(sum) ~constructor ~leaf
