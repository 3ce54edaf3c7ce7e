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

let apply name arguments =
  let arguments = List.init arguments (Variable_name.nth Variable_name.Type) in
  match arguments with
  | [ _ ] -> Printf.sprintf "use `arr %s` to apply it at every instant" name
  | several ->
      Printf.sprintf "use `proc (%s) -> %s %s` to apply it at every instant"
        (String.concat ", " several) name (String.concat " " several)

let rec parameters : Ir.ty -> Ir.ty list * Ir.ty = function
  | Function (a, b) ->
      let others, result = parameters b in
      (a :: others, result)
  | result -> ([], result)

(* `main x = …`, with the signature of a function *)
let as_signal_function (d : Ir.definition) =
  let types, result = parameters d.scheme.ty in
  let names =
    match types with [ _ ] -> [ "x" ] | _ -> List.mapi (fun i _ -> Variable_name.nth Type i) types
  in
  let tuple = function [ one ] -> one | several -> "(" ^ String.concat ", " several ^ ")" in
  Printf.sprintf "write `%s :: SF %s %s` and `%s = proc %s -> …`" d.name.name
    (Source.grouped (tuple (List.map Show.ty types)))
    (Source.grouped (Show.ty result))
    d.name.name (tuple names)

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

(* Is the program a ROS 2 node? Follows the definitions of the program. The output of a node is a
   record of topics or `()`; a later pass reports anything else. *)
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

(* A variable in the definition's type that has the same name as a definition of the program. *)
let size_of_a_name (program : Ir.program) (d : Ir.definition) =
  let is_a_value (v : Ir.variable) =
    List.exists
      (fun (other : Ir.definition) ->
        String.equal other.name.name v.name && String.equal other.name.module_ d.name.module_)
      program.definitions
  in
  Option.map (fun (v : Ir.variable) -> v.name) (List.find_opt is_a_value d.scheme.types)

let refusal program ~closed (d : Ir.definition) =
  let name = d.name.name and ty = Show.scheme d.scheme in
  let refuse ?(at = d.span) what cure =
    Some (Diagnostic.error ~code:"E0411" ~at "`%s` cannot run: %s" name what |> Diagnostic.hint cure)
  in
  match kind d.scheme.ty with
  | (Signal_function { output } | Program { output }) when sets_output program d output ->
      refuse ~at:(output_of program d.value)
        (Printf.sprintf "its output is a function, `%s`, not the output of a robot" (Show.ty output))
        "use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v \
         omega)`"
  | Program { output = Function _ | Number _ | Bool | Tuple _ } when not (is_node program d) ->
      refuse ~at:(output_of program d.value)
        (Printf.sprintf "its type is `%s`, whose output is not the output of a robot" ty)
        "use `roMake` to make the output of a robot, as in `roMake (setVelTR v omega)`"
  | (Signal_function _ | Program _) when closed || is_closed d -> None
  | (Signal_function _ | Program _) when size_of_a_name program d <> None ->
      let size = Option.get (size_of_a_name program d) in
      refuse
        (Printf.sprintf "its type `%s` has variables, so the input or the output is not determined"
           ty)
        (Printf.sprintf
           "`%s` is a variable for any size here, not the value of that name: write a number, or a \
            name for it, as in `type N = 4`"
           size)
  | Signal_function _ | Program _ ->
      refuse
        (Printf.sprintf "its type `%s` has variables, so the input or the output is not determined"
           ty)
        (Printf.sprintf "give it a signature without variables, such as `%s :: %s`" name
           (match kind d.scheme.ty with
           | Program _ -> "Program In Out"
           | Signal_function _ | Task | Function _ | Value -> "SF Float Float"))
  | Function { result = Signal_function _ | Program _; _ } ->
      refuse
        (Printf.sprintf "it still needs an argument, as its type `%s` shows" ty)
        (if String.equal name "main" then
           "give it another name, such as `run`, and write `main = run …`"
         else Printf.sprintf "define another one with the argument, as in `main = %s …`" name)
  | Task ->
      refuse
        (Printf.sprintf "it is a task, `%s`, not a signal function" ty)
        (Printf.sprintf
           "use `runTask %s` for a signal function, or `reactimateTask %s` for a robot program" name
           name)
  | Function { arguments; _ } ->
      refuse
        (Printf.sprintf "it is a function, `%s`, not a signal function" ty)
        (if sets_output program d d.scheme.ty then
           "to set a robot's output, write `reactimateRobot (proc i -> roMake (setVelTR v omega))`"
         else if String.equal name "main" && is_closed d then as_signal_function d
         else apply name arguments)
  | Value ->
      refuse
        (match d.scheme.ty with
        | Number _ | Variable _ -> "it is a value, not a signal function"
        | ty -> Printf.sprintf "it is a value of type `%s`, not a signal function" (Show.ty ty))
        (if String.equal name "main" then
           "use `constant e` for a signal function that always returns it, or `main = \
            reactimateRobot (constant e)` for a robot program"
         else Printf.sprintf "use `constant %s` for a signal function that always returns it" name)

(* {1 Choice of the entry} *)

let own (program : Ir.program) =
  List.filter
    (fun (d : Ir.definition) -> String.equal d.name.module_ program.main_module)
    program.definitions

let no_entry = "E0501"

let find sink program ~file name =
  let own = own program in
  let found = List.find_opt (fun (d : Ir.definition) -> String.equal d.name.name name) own in
  if Option.is_none found then
    Diagnostic.error ~code:no_entry ~at:(Span.start_of_file file)
      "there is no `%s` in this module to compile" name
    |> Diagnostic.hint
         (match
            ( Resolve.Test_file.program file,
              Suggest.closest name (List.map (fun (d : Ir.definition) -> d.name.name) own) )
          with
         | Some program, _ when String.equal name "main" ->
             Printf.sprintf "this is a test file: give the name of its program, %s"
               (Printable.name program)
         | _, Some name -> Printf.sprintf "did you mean `--entry %s`?" (Printable.word name)
         | _, None -> "define `main`, or name a signal function of this module with `--entry NAME`")
    |> Diagnostic.emit sink;
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
