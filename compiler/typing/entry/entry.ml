open Basis

type kind =
  | Signal_function of { output : Ir.ty }
  | Program of { output : Ir.ty }
  | Task
  | Function of { arguments : int; result : kind }
  | Value

let rec kind : Ir.ty -> kind = function
  | Signal_function (_, output) -> Signal_function { output }
  | Data { tycon; arguments = [ _; output ]; _ } when tycon = Environment.built_in "Program" ->
      Program { output }
  | Data { tycon; _ } when tycon = Environment.task -> Task
  | Function (_, result) -> (
      match kind result with
      | Function { arguments; result } -> Function { arguments = arguments + 1; result }
      | result -> Function { arguments = 1; result })
  | Variable _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ -> Value

(* The type of the function's last argument, if the function returns that same type. *)
let rec changed : Ir.ty -> Ir.ty option = function
  | Function (a, b) -> if a = b then Some a else changed b
  | _ -> None

(* Is this a type variable that a declared class constrains, or a robot's output type? *)
let is_robot_output (program : Ir.program) (d : Ir.definition) (ty : Ir.ty) =
  match ty with
  | Variable _ ->
      let asks ((class_ : Ir.class_), asked) =
        match class_ with Declared _ -> asked = ty | Eq | Ord -> false
      in
      List.exists asks d.scheme.context
  | Data { tycon; _ } ->
      let gives (i : Ir.instance) =
        String.equal i.class_.name "RobotOutput"
        && match i.head with Data head -> head.tycon = tycon | _ -> false
      in
      List.exists gives program.instances
  | _ -> false

(* Does the function set a robot's output? Such functions, for example the library's capability
   functions, are meant to be passed to `roMake`. *)
let sets_output program d ty =
  match changed ty with Some changed -> is_robot_output program d changed | None -> false

(* The place of the output expression. *)
let rec output_of (program : Ir.program) (e : Ir.expr) =
  let is_it (g : Ir.Global.t) (d : Ir.definition) =
    d.name = g && String.equal g.module_ program.main_module
  in
  match e.desc with
  | Apply (_, argument) -> output_of program argument
  | Global (g, _) -> (
      match List.find_opt (is_it g) program.definitions with
      | Some { value = { desc = Proc { output; _ }; _ }; _ } -> output.span
      | Some _ | None -> e.span)
  | Proc { output; _ } -> output.span
  | _ -> e.span

(* Is the program a ROS 2 node? Follows references to the program's definitions. The output of a
   node is a record of topics or `()`; a later pass reports anything else. *)
let is_node (program : Ir.program) (d : Ir.definition) =
  let rec within depth (e : Ir.expr) =
    match e.desc with
    | Primitive (g, _) -> g = { module_ = "Ros"; name = "node" }
    | Apply (e, _) | If (_, e, _) | Lambda (_, e) -> within depth e
    | Let (bindings, e) ->
        within depth e || List.exists (fun (b : Ir.binding) -> within depth b.value) bindings
    | Global (g, _) when depth > 0 ->
        List.exists
          (fun (d : Ir.definition) -> d.name = g && within (depth - 1) d.value)
          program.definitions
    | _ -> false
  in
  within 20 d.value

let is_closed (d : Ir.definition) = d.scheme.types = [] && d.scheme.representations = []

(* A variable in the definition's type that has the same name as a definition in the same module. *)
let size_of_a_name (program : Ir.program) (d : Ir.definition) =
  let is_a_value (v : Ir.variable) =
    List.exists
      (fun (other : Ir.definition) ->
        String.equal other.name.name v.name && String.equal other.name.module_ d.name.module_)
      program.definitions
  in
  Option.map (fun (v : Ir.variable) -> v.name) (List.find_opt is_a_value d.scheme.types)

let refusal program ~closed (d : Ir.definition) : Entry_fact.refusal option =
  match kind d.scheme.ty with
  | (Signal_function { output } | Program { output }) when sets_output program d output ->
      Some (Function_as_output { output; at = output_of program d.value })
  | Program { output = Function _ | Number _ | Bool | Tuple _ } when not (is_node program d) ->
      Some (Not_a_robot_output (output_of program d.value))
  | (Signal_function _ | Program _) when closed || is_closed d -> None
  | Signal_function _ ->
      Some (Type_variables { is_program = false; size = size_of_a_name program d })
  | Program _ -> Some (Type_variables { is_program = true; size = size_of_a_name program d })
  | Function { result = Signal_function _ | Program _; _ } -> Some Missing_argument
  | Task -> Some Task
  | Function { arguments; _ } ->
      let sets_output = sets_output program d d.scheme.ty in
      Some (Function { arguments; sets_output; is_closed = is_closed d })
  | Value -> Some Value

let accepts facts program ~closed definition =
  match refusal program ~closed definition with
  | None -> true
  | Some refusal ->
      Facts.report facts (Fact.Entry (Refused { definition; refusal }));
      false

(* {1 Choice of the entry} *)

let own (program : Ir.program) =
  List.filter
    (fun (d : Ir.definition) -> String.equal d.name.module_ program.main_module)
    program.definitions

let find facts program ~file name =
  let own = own program in
  let name_of (d : Ir.definition) = d.name.name in
  let found = List.find_opt (fun d -> String.equal (name_of d) name) own in
  if Option.is_none found then
    Facts.report facts (Fact.Entry (No_entry { file; name; others = List.map name_of own }));
  found

let all program =
  let own = own program in
  let could_be (d : Ir.definition) =
    match kind d.scheme.ty with
    | Signal_function _ | Program _ -> is_closed d
    | Task | Function _ | Value -> false
  in
  match List.filter (fun (d : Ir.definition) -> d.name.name = "main") own with
  | [] -> List.filter could_be own
  | main -> main

let is_signed (program : Resolve.Ir.program) name =
  let is_it (b : Resolve.Ir.binding) =
    match b.name with
    | Top (top, _) -> top = name && Option.is_some b.signature
    | Inner _ | Destructure _ -> false
  in
  let among (g : Resolve.Ir.binding_group) = List.exists is_it g.bindings in
  List.exists among program.groups
