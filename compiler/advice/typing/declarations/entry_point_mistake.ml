open Basis
open Typing

let signal_function_of name arguments =
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

(* The hint for `main x = …` with the signature of a function. *)
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

let rejected (d : Ir.definition) ?(at = d.span) hint format =
  Printf.ksprintf
    (fun reason ->
      Diagnostic.error ~code:"E0411" ~at "`%s` cannot run: %s" d.name.name reason
      |> Diagnostic.hint "%s" hint)
    format

let type_variables d ~name ~ty ~is_program size =
  let hint =
    match size with
    | Some size ->
        Printf.sprintf
          "here `%s` is a variable for any array size, not the value with that name: write a \
           number, or name the size, as in `type N = 4`"
          size
    | None ->
        Printf.sprintf "give it a signature without variables, such as `%s :: %s`" name
          (if is_program then "Program In Out" else "SF Float Float")
  in
  rejected d hint "its type `%s` has variables, so the input or the output is not determined" ty

let function_ (d : Ir.definition) ~name ~ty ~arguments ~sets_output ~is_closed =
  let hint =
    if sets_output then
      "to set a robot's output, write `reactimateRobot (proc i -> roMake (setVelTR v omega))`"
    else if String.equal name "main" && is_closed then as_signal_function d
    else signal_function_of name arguments
  in
  rejected d hint "it is a function, `%s`, not a signal function" ty

let value (d : Ir.definition) ~name =
  let hint =
    if String.equal name "main" then
      "use `constant e` for a signal function that always outputs the value `e`, or `main = \
       reactimateRobot (constant e)` for a robot program"
    else
      Printf.sprintf "use `constant %s` for a signal function that always outputs this value" name
  in
  match d.scheme.ty with
  | Number _ | Variable _ -> rejected d hint "it is a value, not a signal function"
  | ty -> rejected d hint "it is a value of type `%s`, not a signal function" (Show.ty ty)

let refused (d : Ir.definition) (refusal : Entry_fact.refusal) =
  let name = d.name.name and ty = Show.scheme d.scheme in
  match refusal with
  | Function_as_output { output; at } ->
      rejected d ~at
        "use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v \
         omega)`"
        "its output is a function, `%s`, not a robot's output" (Show.ty output)
  | Not_a_robot_output at ->
      rejected d ~at "use `roMake` to create a robot's output, as in `roMake (setVelTR v omega)`"
        "its type is `%s`, so its output is not a robot's output" ty
  | Type_variables { is_program; size } -> type_variables d ~name ~ty ~is_program size
  | Missing_argument ->
      rejected d
        (if String.equal name "main" then
           "give it another name, such as `run`, and write `main = run …`"
         else
           Printf.sprintf "define a signal function that supplies the argument, as in `main = %s …`"
             name)
        "it still needs an argument, as its type `%s` shows" ty
  | Task ->
      rejected d
        (Printf.sprintf
           "use `runTask %s` for a signal function, or `reactimateTask %s` for a robot program" name
           name)
        "it is a task, `%s`, not a signal function" ty
  | Function { arguments; sets_output; is_closed } ->
      function_ d ~name ~ty ~arguments ~sets_output ~is_closed
  | Value -> value d ~name

let no_entry = "E0501"

let diagnostic (fact : Entry_fact.t) =
  match fact with
  | Refused { definition; refusal } -> refused definition refusal
  | No_entry { file; name; others } ->
      Diagnostic.error ~code:no_entry ~at:(Span.start_of_file file)
        "this module has no `%s` to compile" name
      |> Diagnostic.hint "%s"
           (match (Resolve.Test_file.program file, Suggest.closest name others) with
           | Some program, _ when String.equal name "main" ->
               Printf.sprintf "this is a test file: instead, name the program that it tests, %s"
                 (Printable.name program)
           | _, Some name -> Printf.sprintf "did you mean `--entry %s`?" (Printable.word name)
           | _, None ->
               "define `main`, or name a signal function of this module with `--entry NAME`")
