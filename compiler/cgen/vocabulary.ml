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
  elementary : (string, unit) Hashtbl.t;
  makers : (int * int, unit) Hashtbl.t;
  projections : (int * int * int, unit) Hashtbl.t;
  arrays : arrays;
  operations : (Array_type.operation * M.ty, string) Hashtbl.t;
}

(* Structs of arrays, as they are met. *)
and arrays = {
  names : (M.ty, string) Hashtbl.t;
  of_robots : (M.ty, unit) Hashtbl.t;  (** those that are in a robot's header *)
  mutable met : M.ty list;  (** last first *)
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
        | Value _ | State_of _ | States_of _ | Running_mode -> None)
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

let rec name_array arrays scope ~name sums (ty : M.ty) =
  match Hashtbl.find_opt arrays.names ty with
  | Some name -> name
  | None ->
      (* The type of its elements is defined with it. *)
      (match ty with
      | Array (_, (Array _ as element)) ->
          ignore (name_array arrays scope ~name sums element : string)
      | Array _ | Bool | Int | Float | Nanoseconds | Sum _ -> ());
      let prefix = if Hashtbl.mem arrays.of_robots ty then "frob" else name in
      let name = Name.fresh scope (prefix ^ "_" ^ Array_type.name sums ty) in
      Hashtbl.replace arrays.names ty name;
      arrays.met <- ty :: arrays.met;
      name

let of_program (program : M.program) =
  let name = Name.identifier program.name in
  let scope = Name.scope Identifiers ~taken:Helper.names in
  let input_name = Name.fresh scope (name ^ "_input") in
  let output_name = Name.fresh scope (name ^ "_output") in
  (* What a host calls and sees has the first choice: the root's names are the
     program's own, its types come before the functions inside. *)
  let root = name_root scope ~name in
  let arrays = { names = Hashtbl.create 16; of_robots = Hashtbl.create 4; met = [] } in
  let foreign = Array.make (Array.length program.sums) false in
  let robot_of shape =
    let robot = Robot.of_shape shape in
    let rec mark (ty : F.ty) =
      match ty with
      | Sum k ->
          foreign.(k) <- true;
          List.iter
            (fun (ty, _) ->
              Hashtbl.replace arrays.of_robots (Machine.Layout.ty ty) ();
              mark ty)
            (Machine.Layout.sum program.sums k).arrays
      | Array (_, element) -> mark element
      | Bool | Int | Float -> ()
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
        let slots = Machine.Layout.sum program.sums k in
        let array (ty, _) =
          (ty, Ir.Struct (name_array arrays scope ~name program.sums (Machine.Layout.ty ty)))
        in
        Sum_type.name scope ~prefix sum ~slots ~arrays:(List.map array slots.arrays))
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
    elementary = Hashtbl.create 4;
    makers = Hashtbl.create 16;
    projections = Hashtbl.create 16;
    arrays;
    operations = Hashtbl.create 16;
  }

let ty t (ty : M.ty) : Ir.ty =
  match ty with
  | Array _ -> Struct (name_array t.arrays t.file_scope ~name:t.name t.program.sums ty)
  | Bool -> Bool
  | Int -> Int32
  | Float -> Real
  | Nanoseconds -> Int64
  | Sum k -> Struct t.sums.(k).struct_name

let helper t helper =
  Hashtbl.replace t.helpers helper ();
  Helper.name helper

let runtime_function t name =
  let name = "frob_" ^ name in
  Hashtbl.replace t.elementary name ();
  name

let elementary t (f : Core.Primitive.elementary) =
  let name = Core.Primitive.name (Elementary f) in
  match f with
  | Sqrt -> name
  | Hypot | Exp | Log | Sin | Cos | Tan | Asin | Acos | Atan | Atan2 -> runtime_function t name

let pow t = runtime_function t "pow"

let maker t ~sum ~constructor =
  Hashtbl.replace t.makers (sum, constructor) ();
  t.sums.(sum).makers.(constructor)

let projection t ~sum ~constructor ~leaf =
  Hashtbl.replace t.projections (sum, constructor, leaf) ();
  Sum_type.projection_name t.sums.(sum) ~constructor ~leaf

let array_function t operation array =
  match Hashtbl.find_opt t.operations (operation, array) with
  | Some name -> name
  | None ->
      let struct_name = name_array t.arrays t.file_scope ~name:t.name t.program.sums array in
      let name = Name.fresh t.file_scope (struct_name ^ "_" ^ Array_type.suffix operation) in
      Hashtbl.replace t.operations (operation, array) name;
      name

let size_and_element : M.ty -> int * M.ty = function
  | Array (count, element) -> (count, element)
  | Bool | Int | Float | Nanoseconds | Sum _ ->
      Basis.Diagnostic.bug ~stage:"Cgen.Vocabulary" "an array that is none"

let array_functions t =
  let function_ array operation =
    let count, element = size_and_element array in
    Option.map
      (fun name ->
        Array_type.function_ operation name
          ~struct_name:(Hashtbl.find t.arrays.names array)
          ~count ~element:(ty t element))
      (Hashtbl.find_opt t.operations (operation, array))
  in
  List.concat_map
    (fun array -> List.filter_map (function_ array) Array_type.operations)
    (List.rev t.arrays.met)

(* Each type after those that it is made of. *)
let type_definitions t ~foreign =
  let sums_done = Array.make (Array.length t.sums) false and arrays_done = Hashtbl.create 16 in
  let definitions = ref [] in
  let add declarations = definitions := List.rev_append declarations !definitions in
  let rec sum k =
    if not sums_done.(k) then (
      sums_done.(k) <- true;
      List.iter (fun (ty, _) -> array (Machine.Layout.ty ty)) t.sums.(k).slots.arrays;
      if Bool.equal t.foreign.(k) foreign then
        add (Sum_type.definition t.program.sums t.program.sums.(k) t.sums.(k)))
  and array array_ty =
    if not (Hashtbl.mem arrays_done array_ty) then (
      Hashtbl.replace arrays_done array_ty ();
      let count, element = size_and_element array_ty in
      (match element with
      | Sum k -> sum k
      | Array _ -> array element
      | Bool | Int | Float | Nanoseconds -> ());
      if Bool.equal (Hashtbl.mem t.arrays.of_robots array_ty) foreign then
        let name = Hashtbl.find t.arrays.names array_ty in
        add [ Array_type.definition name ~count ~element:(ty t element) ])
  in
  Array.iteri (fun k _ -> sum k) t.sums;
  List.iter array (List.rev t.arrays.met);
  List.rev !definitions
