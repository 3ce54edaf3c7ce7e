module F = Flow.Ir
open Printf

type side = { own : Interface.t; host : Interface.t; robot : Robot.t option }

let bug format = Basis.Diagnostic.bug ~stage:"Cgen.Border" format

(* The robot of a single-precision program; [None] in double precision. *)
let robot_of ?own (program : Step.Ir.program) shape =
  match program.real with Double -> None | Single -> Robot.of_shape ?own shape

let robot_struct (shape : F.shape) =
  match shape with
  | Product { product_name; _ } -> "frob_" ^ Name.snake product_name
  | Leaf _ | Repeated _ -> bug "the type of a robot must be a record"

let same own = { own; host = own; robot = None }
let host_input = "host_input"
let host_output = "host_output"
let own_part = Interface.Member "own"

(* In both structs, the console has the program's own type. *)
let input ?own_robot (program : Step.Ir.program) (own : Interface.t) =
  match (robot_of ?own:own_robot program program.input, Robot.apart program.input) with
  | None, _ -> same own
  | robot, (_, None) -> { own; host = { own with struct_name = robot_struct program.input }; robot }
  | robot, (_, Some { part = _, console; at }) ->
      let count = List.length (Flow.Shape.leaves console) in
      let leaf k path =
        if k >= at && k < at + count then own_part :: path else Interface.Member "robot" :: path
      in
      let leaves = List.mapi leaf own.leaves in
      { own; host = { own with struct_name = host_input; leaves }; robot }

(* In both structs, everything except the command has the program's own type. *)
let output ?own_robot (program : Step.Ir.program) (own : Interface.t) =
  let command, result =
    if program.ends then Interface.apart program.output else (program.output, None)
  in
  match robot_of ?own:own_robot program command with
  | None -> same own
  | robot when result = None && program.probes = [] ->
      { own; host = { own with struct_name = robot_struct command }; robot }
  | robot ->
      let count = List.length (Flow.Shape.leaves command) in
      let commands path =
        match path with
        | Interface.Member "command" :: rest when program.probes <> [] -> rest
        | path -> path
      in
      let leaf k path =
        if k < count then Interface.Member "command" :: commands path else own_part :: path
      in
      let leaves = List.mapi leaf own.leaves in
      { own; host = { own with struct_name = host_output; leaves }; robot }

let includes sides =
  let header side = Option.map (fun r -> sprintf "#include %s\n" (Robot.included r)) side.robot in
  String.concat "" (List.sort_uniq compare (List.filter_map header sides))

let has_own side = side.robot <> None && List.mem side.host.struct_name [ host_input; host_output ]

let definitions (program : Step.Ir.program) side =
  let definition ~first shape =
    sprintf "struct %s {\n    struct %s %s;\n    struct %s own;\n};\n\n" side.host.struct_name
      (robot_struct shape) first side.own.struct_name
  in
  if not (has_own side) then ""
  else if String.equal side.host.struct_name host_input then definition ~first:"robot" program.input
  else
    definition ~first:"command"
      (if program.ends then fst (Interface.apart program.output) else program.output)

(* {1 Conversion} *)

let index depth = Char.chr (Char.code 'i' + depth)

(* [root] ends with the operator that selects a member. *)
let path root (steps : Interface.step list) =
  let add (text, depth) (step : Interface.step) =
    match step with
    | Member name when String.equal text root -> (text ^ name, depth)
    | Member name -> (sprintf "%s.%s" text name, depth)
    | Element _ -> (sprintf "%s[%c]" text (index depth), depth + 1)
  in
  fst (List.fold_left add (root, 0) steps)

let sizes steps =
  List.filter_map (function Interface.Element n -> Some n | Member _ -> None) steps

(* The assignments for one leaf, as lines without indentation. *)
let rec assignments (program : Step.Ir.program) sums (ty : F.ty) ~to_ ~from ~cast =
  let equal to_ from = sprintf "%s = %s;" to_ from in
  let scalar (ty : Ir.ty) to_ from =
    match ty with Real _ -> sprintf "%s = (%s)%s;" to_ cast from | _ -> equal to_ from
  in
  match ty with
  | Float -> [ scalar (Real program.real) to_ from ]
  | Bool | Int -> [ equal to_ from ]
  | Sum k ->
      let member (name, ty) =
        match (ty : Ir.ty) with
        | Struct _ -> bug "a sum in a robot's type cannot contain an array"
        | ty -> scalar ty (to_ ^ "." ^ name) (from ^ "." ^ name)
      in
      List.map member (("tag", Ir.Uint8) :: Sum_type.members program.sums sums.(k))
  | Array (_, element) -> assignments program sums element ~to_ ~from ~cast
  | Foreign _ -> bug "a robot's type cannot contain a foreign type"

let copy out steps assignments =
  let sizes = sizes steps in
  let indent k = String.make (4 * (k + 1)) ' ' in
  List.iteri
    (fun k size ->
      let i = index k in
      bprintf out "%sfor (int %c = 0; %c < %d; %c++) {\n" (indent k) i i size i)
    sizes;
  let depth = List.length sizes in
  List.iter (fun line -> bprintf out "%s%s\n" (indent depth) line) assignments;
  List.iteri (fun k _ -> bprintf out "%s}\n" (indent (depth - 1 - k))) sizes

let is_own side (steps : Interface.step list) =
  has_own side && match steps with first :: _ -> first = own_part | [] -> false

let convert out program sums shape side ~own ~host ~inward =
  let leaf ty own_steps host_steps =
    let own = path own own_steps and host = path host host_steps in
    let lines =
      if is_own side host_steps then []
      else if inward then assignments program sums ty ~to_:own ~from:host ~cast:"float"
      else assignments program sums ty ~to_:host ~from:own ~cast:"double"
    in
    if lines <> [] then copy out own_steps lines
  in
  let rec go types own host =
    match (types, own, host) with
    | ty :: types, own_steps :: own, host_steps :: host ->
        leaf ty own_steps host_steps;
        go types own host
    | [], _, _ -> ()
    | _, _, _ -> bug "the two sides have different leaves"
  in
  if inward && has_own side then bprintf out "    own_in = host_in->own;\n";
  go (Flow.Shape.leaves shape) side.own.leaves side.host.leaves;
  if has_own side && not inward then bprintf out "    host_out->own = own_out;\n"

(* {1 The step} *)

(* Hosts always pass [params] to the table's functions. *)
let passed = function
  | None -> ("    (void)params;\n", "")
  | Some params -> ("", sprintf ", (const struct %s *)params" (Param_struct.struct_name params))

let arithmetic =
  {|
static unsigned arithmetic(void)
{
    return frob_arithmetic_faults() | frob_arithmetic_float_faults();
}
|}

let step ~params (program : Step.Ir.program) sums ~name ~input ~output =
  let out = Buffer.create 1024 in
  let unread, passed = passed params in
  let own_type side = "struct " ^ side.own.struct_name in
  let host_type side = "struct " ^ side.host.struct_name in
  bprintf out
    "\n\
     static void step(void *state, const void *params, int64_t dt_ns, double dt, const void *in,\n\
    \                 void *out)\n\
     {\n\
     %s"
    unread;
  let given side ~constant name =
    match side.robot with
    | None -> sprintf "(%s%s *)%s" constant (own_type side) name
    | Some _ -> sprintf "&own_%s" name
  in
  let declare side ~constant name =
    if side.robot <> None then (
      bprintf out "    %s%s *host_%s = (%s%s *)%s;\n" constant (host_type side) name constant
        (host_type side) name;
      bprintf out "    %s own_%s;\n" (own_type side) name)
  in
  declare input ~constant:"const " "in";
  declare output ~constant:"" "out";
  if input.robot <> None then
    convert out program sums program.input input ~own:"own_in." ~host:"host_in->" ~inward:true;
  let dt = match program.real with Double -> "dt" | Single -> "(float)dt_ns / 1e9f" in
  if program.real = Single then Buffer.add_string out "    (void)dt;\n";
  bprintf out "    %s_step_ns((struct %s_state *)state%s, dt_ns, %s, %s, %s);\n" name name passed dt
    (given input ~constant:"const " "in")
    (given output ~constant:"" "out");
  if output.robot <> None then
    convert out program sums program.output output ~own:"own_out." ~host:"host_out->" ~inward:false;
  bprintf out "}\n";
  if program.real = Single then Buffer.add_string out arithmetic;
  Buffer.contents out
