open Basis
open Typing

(* The type of the last argument, if the function may return a value of that type. *)
let rec changed t =
  match Type.expand t with
  | Function (a, b) -> (
      match (Type.expand a, Type.expand b) with
      | Flexible a', Flexible b' when a' == b' -> Some a
      | Rigid a', Rigid b' when a' == b' -> Some a
      | Data { tycon = a'; _ }, Data { tycon = b'; _ } when a' = b' -> Some a
      | _ -> changed b)
  | _ -> None

(* By convention, the names of robots' output records end in `Output`. *)
let is_output t =
  match Type.expand t with
  | Data { tycon; _ } -> String.ends_with ~suffix:"Output" tycon.name
  | _ -> false

let hint_for_a_twist words t =
  match (Type.expand t, Wording.fields words t) with
  | Data { tycon = { name = "Twist"; _ }; _ }, Some (_, fields) when List.mem "linear" fields ->
      Some
        "a robot's output is a command, not a `Twist`: write `roMake (setVelTR v omega)`, where \
         `v` is the `linear` velocity and `omega` the `angular` one"
  | _ -> None

let rec is_of_a_capability (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply { head; style = Juxtaposed; _ } -> is_of_a_capability head
  | Global { module_; _ } -> String.equal module_ "Capability"
  | _ -> false

let program_output t =
  match Type.expand t with
  | Data { tycon; arguments = [ _; output ]; _ } when tycon = Environment.built_in "Program" ->
      Some output
  | _ -> None

let with_ro_make =
  "use `roMake` to turn this function into a robot's output, as in `roMake (setVelTR v omega)`"

let hint (fact : Shape_fact.t) =
  let ends =
    match (program_output fact.expected.ty, program_output fact.found) with
    | Some expected, Some found -> Some (expected, found)
    | _ -> None
  in
  match (changed fact.found, ends) with
  | _, Some (wanted, given) when changed given <> None && changed wanted = None -> Some with_ro_make
  | Some _, _
    when is_output fact.expected.ty || Option.fold fact.subject ~none:false ~some:is_of_a_capability
    ->
      Some with_ro_make
  | _ -> None

let hint_without_instance t = Option.map (fun _ -> with_ro_make) (changed t)

(* The output of the `proc` in this expression, such as `reactimateRobot (proc i -> …)`. *)
let rec output_of (e : Resolve.Ir.expr) =
  match e.desc with
  | Proc { body = { output; _ }; _ } -> Some output
  | Apply { argument; _ } -> output_of argument
  | _ -> None

(* The expression to turn into the robot's output, and its source text. *)
let to_make (fact : Shape_fact.t) =
  Option.bind fact.subject (fun (e : Resolve.Ir.expr) ->
      let e = Option.value (output_of e) ~default:e in
      if is_of_a_capability e then
        Option.map (fun text -> (e, text)) (Wording.quote fact.words e.span)
      else None)

let not_made (fact : Shape_fact.t) =
  match (fact.wanted, fact.given) with
  | (Data _ | Rigid _), (Function _ | Data _) ->
      Option.map
        (fun text ->
          match to_make fact with
          | Some (e, text) ->
              let made = Printf.sprintf "roMake (%s)" text in
              Shape_fact.hinted fact
                "this only changes an output: for the robot's output itself, write `%s`" made
              |> Diagnostic.label ~at:e.span "this is a function"
              |> Diagnostic.fix (Printf.sprintf "write `%s`" made) [ (e.span, "(" ^ made ^ ")") ]
          | None -> Shape_fact.hinted fact "%s" text)
        (hint fact)
  | _ -> None

let is_number t = match Type.expand t with Type.Number _ -> true | _ -> false

(* A speed and a turn rate as a program's output, as in `reactimateRobot (proc i -> (v, omega))`. *)
let speeds_of_a_program (fact : Shape_fact.t) =
  match
    ( program_output fact.expected.ty,
      Option.map Type.expand (program_output fact.found),
      Option.bind fact.subject output_of )
  with
  | Some wanted, Some (Tuple [ v; omega ]), Some { desc = Tuple [ v'; omega' ]; span }
    when is_output wanted && is_number v && is_number omega -> (
      match (Wording.quote fact.words v'.span, Wording.quote fact.words omega'.span) with
      | Some v, Some omega ->
          let text =
            Printf.sprintf "roMake (setVelTR %s %s)" (Source.grouped v) (Source.grouped omega)
          in
          Some
            (Shape_fact.hinted fact "write `%s` for a robot's output with this speed and turn rate"
               text
            |> Diagnostic.write span text)
      | _ -> None)
  | _ -> None

(* A task as a program's output, as in `reactimateRobot (proc i -> forward 1[m])`. *)
let task_of_a_program (fact : Shape_fact.t) =
  match
    (program_output fact.expected.ty, program_output fact.found, Option.bind fact.subject output_of)
  with
  | Some wanted, Some given, Some { span; _ } when is_output wanted && Environment.is_task given ->
      let d =
        Diagnostic.error ~code:"E0301" ~at:span "expected the robot's output, found a task: %s"
          (Wording.described fact.words given)
      in
      Some
        (match (fact.subject, Wording.quote fact.words span) with
        | ( Some
              {
                desc = Apply { head = { desc = Global { name = "reactimateRobot"; _ }; _ }; _ };
                span;
              },
            Some task ) ->
            let text = Printf.sprintf "reactimateTask %s" (Source.grouped task) in
            Diagnostic.hint "to run a task, write `%s`" text d |> Diagnostic.write span text
        | _ -> Diagnostic.hint "to run a task, write `reactimateTask (…)`" d)
  | _ -> None

(* `(v, omega)` in place of a robot's output *)
let speeds (fact : Shape_fact.t) =
  match (fact.given, Shape_fact.all (Shape_fact.elements fact)) with
  | Tuple [ v; omega ], Some [ v'; omega' ]
    when is_output fact.expected.ty && is_number v && is_number omega ->
      let text =
        Printf.sprintf "roMake (setVelTR %s %s)" (Source.grouped v') (Source.grouped omega')
      in
      Some
        (Shape_fact.hinted fact "write `%s` for a robot's output with this speed and turn rate" text
        |> Diagnostic.write fact.at text)
  | _ -> speeds_of_a_program fact

(* `sleepT 2[s] (setVelTR v omega)`, or `sleepT` with its arguments swapped, in a task whose
   signature allows any output *)
let of_sleeping words ~(subject : Resolve.Ir.expr option) other =
  match Option.map (fun (e : Resolve.Ir.expr) -> (e.span, Resolve.Walk.application e)) subject with
  | Some (span, ({ desc = Global { name = "sleepT"; _ }; _ }, [ time; output ])) -> (
      match (Type.expand other, Wording.quote words time.span, Wording.quote words output.span) with
      | Function _, _, Some text when changed other <> None && is_of_a_capability output ->
          let made = Printf.sprintf "roMake (%s)" text in
          Diagnostic.error ~code:"E0301" ~at:output.span
            "expected the robot's output during that time, found %s" (Wording.described words other)
          |> Diagnostic.hint "write `%s`" made
          |> Diagnostic.fix (Printf.sprintf "write `%s`" made) [ (output.span, made) ]
          |> Option.some
      | Number _, Some first, Some second when is_number other ->
          let text = Printf.sprintf "sleepT %s %s" (Source.grouped second) (Source.grouped first) in
          Diagnostic.error ~code:"E0301" ~at:span "the arguments of `sleepT` are in the wrong order"
          |> Diagnostic.hint "write `%s`" text |> Diagnostic.write span text |> Option.some
      | _ -> None)
  | _ -> None

let statement (fact : Shape_fact.t) =
  match fact.given with
  | Function _ when Shape_fact.is_statement fact && changed fact.found <> None ->
      let output = Printf.sprintf "(roMake %s)" (Shape_fact.grouped fact "(…)") in
      Diagnostic.error ~code:"E0370" ~at:fact.at
        "each statement in a `do` must be a task, but this is %s" (Shape_fact.found_text fact)
      |> Diagnostic.hint
           "use `sleepT 1[s] %s` for a task of one second, or `constT %s` for one that never ends"
           output output
      |> Option.some
  | _ -> None

let twist (fact : Shape_fact.t) =
  if is_output fact.expected.ty then
    Option.map (Shape_fact.hinted fact "%s") (hint_for_a_twist fact.words fact.found)
  else None
