module F = Flow.Ir
module M = Machine.Ir

type mode = { constant : string; member : string }

(* The members that lead to the parts of fields. *)
type paths = { large : (int, string list) Hashtbl.t; small : (int, string list) Hashtbl.t }

type node = {
  state : string;
  flags : string;
  reset : string;
  step : string;
  members : paths;
  modes : mode array;
  waiting : string option;
  foreign : Foreign_interface.t option;
}

type owner = Program | Robot | Foreign_code

type t = {
  program : M.program;
  apart : Machine.Apart.t;
  name : string;
  file_scope : Name.scope;
  sums : Sum_type.t array;
  owners : owner array;
  nodes : node array;
  in_seconds : string;
  input : Interface.t;
  output : Interface.t;
  records : Ir.declaration list;
  robot_records : Ir.declaration list;
  foreign_records : Ir.declaration list;
  imports : Foreign_interface.t list;
  robots : Robot.t list;
  helpers : (Helper.t, unit) Hashtbl.t;
  elementary : (string, unit) Hashtbl.t;
  makers : (int * int, unit) Hashtbl.t;
  projections : (int * int * int, unit) Hashtbl.t;
  arrays : arrays;
  operations : (Array_type.operation * M.ty, string) Hashtbl.t;
  absent : (F.foreign_type, string) Hashtbl.t;
}

(* Structs of arrays, as they are met. *)
and arrays = {
  names : (M.ty, string) Hashtbl.t;
  array_owners : (M.ty, owner) Hashtbl.t;  (** of those that are not the program's *)
  mutable met : M.ty list;  (** last first *)
}

let is_array (ty : M.ty) =
  match ty with Array _ -> true | Bool | Int | Float | Nanoseconds | Sum _ | Foreign _ -> false

let foreign_type (ty : F.foreign_type) : Ir.ty =
  if ty.copyable then Named ty.c_type else Pointer_to_const (Named ty.c_type)

let is_root t k = k = Array.length t.program.nodes - 1
let has_modes t =
  Array.exists
    (fun (node : M.node) -> match node.modes with [] | [ _ ] -> false | _ :: _ :: _ -> true)
    t.program.nodes

let has_state t k = match t.program.nodes.(k).state with [] -> false | _ :: _ -> true

let small_suffix = "_flags"

(* The members of structs with these fields, each after a path: of one struct, or of
   one for each part. *)
let name_members apart k tables ~structs fields =
  let scope = Name.scope Members in
  let large, small, separate =
    match structs with `One path -> (path, path, false) | `Two (large, small) -> (large, small, true)
  in
  let put table (field : M.field) path name = Hashtbl.replace table field.id (List.rev (name :: path)) in
  List.iter
    (fun (field : M.field) ->
      let name = Name.fresh scope field.name in
      match Machine.Apart.parts apart k field with
      | [ Small ] -> put tables.small field small name
      | Large :: more ->
          put tables.large field large name;
          if more <> [] then
            put tables.small field small
              (if separate then name else Name.fresh scope (field.name ^ small_suffix))
      | _ -> Basis.Diagnostic.bug ~stage:"Cgen.Vocabulary" "a field without parts")
    fields

(* Modes are named after their definitions. *)
let name_modes (nodes : M.node array) apart k tables scope ~prefix (node : M.node) =
  let modes = Name.scope Members in
  let is_room (field : M.field) =
    match field.content with
    | Modes _ -> true
    | Value _ | State_of _ | States_of _ | Running_mode | Component _ -> false
  in
  let room table =
    let path (field : M.field) = Hashtbl.find_opt table field.id in
    List.rev (Option.value (Option.bind (List.find_opt is_room node.state) path) ~default:[])
  in
  let constant name =
    Name.fresh scope (String.uppercase_ascii (Name.identifier (prefix ^ "_" ^ Name.snake name)))
  in
  let name (mode : M.mode) =
    let definition = nodes.(mode.node).origin in
    let member = Name.fresh modes definition in
    let structs = `Two (member :: room tables.large, member :: room tables.small) in
    name_members apart k tables ~structs (Machine.State.fields_of_mode mode);
    let constant =
      match node.modes with
      | [] | [ _ ] -> ""
      | _ :: _ :: _ -> constant member
    in
    { constant; member }
  in
  let modes = Array.of_list (List.map name node.modes) in
  let waits =
    List.exists (function M.Await _ -> true | _ -> false) node.reset.body
  in
  (modes, if waits then Some (constant "start") else None)

let members scope ~prefix nodes apart k (node : M.node) =
  let tables = { large = Hashtbl.create 16; small = Hashtbl.create 16 } in
  let structs = if Machine.Apart.is_split apart k then `Two ([], []) else `One [] in
  name_members apart k tables ~structs node.state;
  let modes, waiting = name_modes nodes apart k tables scope ~prefix node in
  (tables, modes, waiting)

(* With [root_in_seconds] as a step of its own, the root's is in nanoseconds. *)
type root = { root_state : string; root_reset : string; root_step : string; root_in_seconds : string }

let name_root scope ~name ~(real : Basis.Real.t) =
  let take suffix = Name.fresh scope (name ^ suffix) in
  let root_state = take "_state" in
  let root_reset = take "_reset" in
  let root_in_seconds = take "_step" in
  let root_step = match real with Double -> root_in_seconds | Single -> take "_step_ns" in
  { root_state; root_reset; root_step; root_in_seconds }

(* What the programs around may know by the same name begins so. *)
let shared_prefix = "frob"
let prefix ~name = function Program -> name | Robot | Foreign_code -> shared_prefix

let name_nodes scope ~name ~root ~foreign apart (nodes : M.node array) =
  let last = Array.length nodes - 1 in
  Array.mapi
    (fun k (node : M.node) ->
      let own = name ^ "_" ^ node.name in
      let prefix = if k = last then name else own in
      let members, modes, waiting = members scope ~prefix nodes apart k node in
      let flags = if Machine.Apart.is_split apart k then Name.fresh scope (own ^ small_suffix) else "" in
      let names ~state ~reset ~step = { state; flags; reset; step; members; modes; waiting; foreign = foreign.(k) } in
      if k = last then names ~state:root.root_state ~reset:root.root_reset ~step:root.root_step
      else
        match (node.state, node.foreign) with
        | [], _ -> names ~state:"" ~reset:"" ~step:(Name.fresh scope own)
        | _ :: _, Some { import = { symbol; _ }; _ } ->
            names ~state:(Foreign_interface.state symbol) ~reset:(Foreign_interface.reset symbol)
              ~step:(Name.fresh scope (own ^ "_step"))
        | _ :: _, None ->
            let state = Name.fresh scope (own ^ "_state") in
            let reset = Name.fresh scope (own ^ "_reset") in
            names ~state ~reset ~step:(Name.fresh scope (own ^ "_step")))
    nodes

let rec name_array arrays scope ~name sums (ty : M.ty) =
  match Hashtbl.find_opt arrays.names ty with
  | Some name -> name
  | None ->
      (* The type of its elements is defined with it. *)
      (match ty with
      | Array (_, (Array _ as element)) ->
          ignore (name_array arrays scope ~name sums element : string)
      | Array _ | Bool | Int | Float | Nanoseconds | Sum _ | Foreign _ -> ());
      let owner = Option.value (Hashtbl.find_opt arrays.array_owners ty) ~default:Program in
      let name = Name.fresh scope (prefix ~name owner ^ "_" ^ Array_type.name sums ty) in
      Hashtbl.replace arrays.names ty name;
      arrays.met <- ty :: arrays.met;
      name

(* What C code of the user's is called. *)
let foreign_names (program : M.program) =
  let names (f : F.import) =
    match f.kind with
    | Function -> [ f.symbol ]
    | Signal_function ->
        List.map (( ^ ) f.symbol) [ "_state"; "_input"; "_output"; "_reset"; "_step" ]
  in
  List.concat_map names program.imports

let of_program ?own (program : M.program) =
  let name = Name.identifier program.name in
  let scope = Name.scope Identifiers ~taken:(foreign_names program @ Helper.names) in
  let input_name = Name.fresh scope (name ^ "_input") in
  let output_name = Name.fresh scope (name ^ "_output") in
  (* What a host calls and sees has the first choice: the root's names are the
     program's own, its types come before the functions inside. *)
  let root = name_root scope ~name ~real:program.real in
  let arrays = { names = Hashtbl.create 16; array_owners = Hashtbl.create 4; met = [] } in
  let owners = Array.make (Array.length program.sums) Program in
  let rec mark owner (ty : F.ty) =
    match ty with
    | Sum k ->
        if owners.(k) = Program then owners.(k) <- owner;
        List.iter
          (fun (ty, _) ->
            let array = Machine.Layout.ty ty in
            if is_array array && not (Hashtbl.mem arrays.array_owners array) then
              Hashtbl.replace arrays.array_owners array owner;
            mark owner ty)
          (Machine.Layout.sum program.sums k).arrays
    | Array (_, element) -> mark owner element
    | Bool | Int | Float | Foreign _ -> ()
  in
  let mark_leaves owner shape = List.iter (mark owner) (Machine.Layout.shape_leaves shape) in
  (* Robots' structs are of doubles; the program's own are as it computes, and its
     table for hosts converts. *)
  let robot_of shape =
    let robot = match program.real with Double -> Robot.of_shape ?own shape | Single -> None in
    if Option.is_some robot then mark_leaves Robot shape;
    robot
  in
  let command, result =
    if program.ends then Interface.apart program.output else (program.output, None)
  in
  let input_robot = robot_of program.input in
  let output_robot = robot_of command in
  List.iter
    (fun (f : F.import) -> List.iter (mark_leaves Foreign_code) (f.result :: f.arguments))
    program.imports;
  let sums =
    Array.mapi
      (fun k sum ->
        let prefix = prefix ~name owners.(k) in
        let slots = Machine.Layout.sum program.sums k in
        let array (ty, _) =
          match Machine.Layout.ty ty with
          | Foreign foreign -> (ty, foreign_type foreign)
          | array -> (ty, Ir.Struct (name_array arrays scope ~name program.sums array))
        in
        Sum_type.name scope ~prefix ~real:program.real sum ~slots ~arrays:(List.map array slots.arrays))
      program.sums
  in
  let sum k = sums.(k).struct_name in
  let own = Interface.types scope ~real:program.real ~prefix:name ~sum ~foreign:foreign_type in
  let shared = Interface.types scope ~real:Double ~prefix:shared_prefix ~sum ~foreign:foreign_type in
  let interface robot struct_name result (shape : F.shape) =
    match (robot, shape) with
    | Some _, Product { product_name; _ } when Option.is_some result ->
        let command = Interface.of_shape shared ~name:("frob_" ^ Name.snake product_name) shape in
        Interface.with_result own ~name:struct_name command (Option.get result)
    | Some _, Product { product_name; _ } ->
        Interface.of_shape shared ~name:("frob_" ^ Name.snake product_name) shape
    | _, _ -> Interface.of_shape own ~name:struct_name shape
  in
  let input = interface input_robot input_name None program.input in
  let output = interface output_robot output_name result
      (if Option.is_some output_robot then command else program.output) in
  let robot_records = Interface.definitions shared in
  let imports =
    List.map (Foreign_interface.of_import shared ~fresh:(Name.fresh scope)) program.imports
  in
  let interface_of (f : F.foreign) =
    List.find
      (fun (i : Foreign_interface.t) -> String.equal i.symbol f.import.symbol)
      imports
  in
  let foreign = Array.map (fun (node : M.node) -> Option.map interface_of node.foreign) program.nodes in
  let is_robots d = List.memq d robot_records in
  let foreign_records =
    List.filter (fun d -> not (is_robots d)) (Interface.definitions shared)
  in
  let apart = Machine.Apart.of_program program in
  let nodes = name_nodes scope ~name ~root ~foreign apart program.nodes in
  {
    program;
    apart;
    name;
    file_scope = scope;
    sums;
    owners;
    nodes;
    in_seconds = root.root_in_seconds;
    input;
    output;
    records = Interface.definitions own;
    robot_records;
    foreign_records;
    imports;
    robots =
      List.sort_uniq compare (List.filter_map Fun.id [ input_robot; output_robot ]);
    helpers = Hashtbl.create 16;
    elementary = Hashtbl.create 4;
    makers = Hashtbl.create 16;
    projections = Hashtbl.create 16;
    arrays;
    operations = Hashtbl.create 16;
    absent = Hashtbl.create 4;
  }

let real t = Ir.Real t.program.real
let float t x = Ir.Float (t.program.real, x)

let ty t (ty : M.ty) : Ir.ty =
  match ty with
  | Array _ -> Struct (name_array t.arrays t.file_scope ~name:t.name t.program.sums ty)
  | Bool -> Bool
  | Int -> Int32
  | Float -> real t
  | Nanoseconds -> Int64
  | Sum k -> Struct t.sums.(k).struct_name
  | Foreign foreign -> foreign_type foreign

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

let helper t helper =
  Hashtbl.replace t.helpers helper ();
  Helper.name helper

let math_function t name = name ^ Print.real_suffix t.program.real

let runtime_function t name =
  let name = math_function t ("frob_" ^ name) in
  Hashtbl.replace t.elementary name ();
  name

let elementary t (f : Core.Primitive.elementary) =
  let name = Core.Primitive.name (Elementary f) in
  match f with
  | Sqrt -> math_function t name
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
  | Bool | Int | Float | Nanoseconds | Sum _ | Foreign _ ->
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

(* Several programs, and the user's own header, may define what C code of the
   user's knows. *)
let defined struct_name = String.uppercase_ascii struct_name ^ "_DEFINED"

let once struct_name declarations =
  let guard = defined struct_name in
  (Ir.Text (Printf.sprintf "#ifndef %s\n#define %s\n" guard guard) :: declarations)
  @ [ Ir.Text "#endif\n" ]

let shared_once owner struct_name declarations =
  match owner with
  | Program | Robot -> declarations
  | Foreign_code -> once struct_name declarations

(* Each type after those that it is made of. *)
let type_definitions t ~of_:wanted =
  let sums_done = Array.make (Array.length t.sums) false and arrays_done = Hashtbl.create 16 in
  let definitions = ref [] in
  let add declarations = definitions := List.rev_append declarations !definitions in
  let rec sum k =
    if not sums_done.(k) then (
      sums_done.(k) <- true;
      List.iter
        (fun ty -> if is_array ty then array ty)
        (List.map (fun (ty, _) -> Machine.Layout.ty ty) t.sums.(k).slots.arrays);
      if wanted t.owners.(k) then
        add
          (shared_once t.owners.(k) t.sums.(k).struct_name
             (Sum_type.definition t.program.sums t.program.sums.(k) t.sums.(k))))
  and array array_ty =
    if not (Hashtbl.mem arrays_done array_ty) then (
      Hashtbl.replace arrays_done array_ty ();
      let count, element = size_and_element array_ty in
      (match element with
      | Sum k -> sum k
      | Array _ -> array element
      | Bool | Int | Float | Nanoseconds | Foreign _ -> ());
      let owner = Option.value (Hashtbl.find_opt t.arrays.array_owners array_ty) ~default:Program in
      if wanted owner then
        let name = Hashtbl.find t.arrays.names array_ty in
        add (shared_once owner name [ Array_type.definition name ~count ~element:(ty t element) ]))
  in
  Array.iteri (fun k _ -> sum k) t.sums;
  List.iter array (List.rev t.arrays.met);
  List.rev !definitions
