open Basis
open Typing
open Instance_fact

let through_instances words { lacking; culprit; through } diagnostic =
  let asks = Wording.constraint_ words lacking culprit in
  match through with
  | [] -> diagnostic
  | last :: _ -> Diagnostic.label ~at:last.place "this instance requires `%s`" asks diagnostic

let is_signal_function t = match Type.expand t with Signal_function _ -> true | _ -> false

let foreign_of words t =
  match Type.expand t with
  | Data { tycon; _ }
    when (Environment.type_ (Wording.environment words) tycon).definition = Environment.Foreign ->
      Some tycon
  | _ -> None

let same_foreign words a b =
  match (foreign_of words a, foreign_of words b) with Some a, Some b -> a = b | _, _ -> false

(* The types that have an instance of the class. *)
let those_with words class_ =
  let name : Head.t -> string option = function Data g -> Some ("`" ^ g.name ^ "`") | _ -> None in
  List.filter_map name (Environment.heads (Wording.environment words) class_)

(* [robot]: the named type of the robot's input or output. *)
let for_any_robot (class_ : Ir.Global.t) robot =
  let asked =
    match Type.expand robot with
    | Data { tycon; _ } when Filename.check_suffix tycon.name "Output" ->
        Printf.sprintf "(HasOdometry i, %s o)" class_.name
    | _ -> Printf.sprintf "(%s i, DiffDrive o)" class_.name
  in
  Diagnostic.hint
    "for a program that runs on every robot with this capability, write the class instead of the \
     robot's type: `main :: %s => Program i o`"
    asked

let is_function t = match Type.expand t with Function _ -> true | _ -> false

let is_with_an_event t =
  match Type.expand t with Tuple [ _; event ] -> Environment.is_event event | _ -> false

let is_pair t = match Type.expand t with Tuple [ _; _ ] -> true | _ -> false

let about_foreign words t diagnostic =
  match foreign_of words t with
  | None -> diagnostic
  | Some tycon ->
      Diagnostic.hint "only C can compare two values of type `%s`: import a C function that does"
        tycon.name diagnostic

(* Is the class from outside these library modules, and is the type a number, a Boolean or
   declared outside the prelude? Then a missing instance is a likely cause. *)
let is_of_the_program (class_ : Ir.Global.t) culprit =
  (not (List.mem class_.module_ [ "Prelude"; "Capability"; "Trial"; "Display" ]))
  &&
  match Type.expand culprit with
  | Data { tycon; _ } -> not (String.equal tycon.module_ "Prelude")
  | Number _ | Bool -> true
  | _ -> false

(* {1 A missing instance} *)

type fact = {
  words : Wording.t;
  required : required;
  lack : lack;
  culprit : string;  (** the culprit as text *)
}

(* Is the instance missing for the required class itself, rather than for a class that one of its
   instances requires? *)
let is_asked_itself fact = fact.lack.through = []

(* Is the instance missing for the required type itself, rather than for a part of that type? *)
let is_direct fact =
  is_asked_itself fact
  && (Type.expand fact.required.argument == Type.expand fact.lack.culprit
     || same_foreign fact.words fact.required.argument fact.lack.culprit)

let user fact = Required_label.user fact.words fact.required

let name_of_user fact =
  match fact.required.by with Name name -> name | Instance (class_, _) -> Show.class_ class_

let without_hints ({ required; lack; words; culprit; _ } as fact) =
  let at = required.at in
  match lack.lacking with
  | Declared _ when Environment.is_task lack.culprit ->
      Diagnostic.error ~code:"E0371" ~at "%s does not return a task, but %s is needed here"
        (user fact) culprit
  | Declared _ ->
      Diagnostic.error ~code:"E0360" ~at "there is no instance `%s`"
        (Wording.constraint_ words lack.lacking lack.culprit)
  | (Eq | Ord) as class_ ->
      let what = match class_ with Eq -> "equality" | Ord | Declared _ -> "order" in
      let of_ = if lack.through = [] then Wording.quoted words required.argument else culprit in
      Diagnostic.error ~code:"E0307" ~at "%s has no %s" of_ what

let where_needed ({ required; lack; words; _ } as fact) d =
  if Environment.is_task lack.culprit then d
  else
    Diagnostic.here "%s needs it" (user fact) d
    |> through_instances words lack |> Required_label.add words required

(* {2 Rules}

   Each rule that applies returns a function that completes the message. *)

(* `roMake` applied to several functions. *)
let several_outputs fact =
  match fact.lack.lacking with
  | Declared { name = "RobotOutput"; _ }
    when fact.required.by = Name "roMake" && is_function fact.lack.culprit ->
      Some
        (fun d ->
          Diagnostic.message "`roMake` takes one function, and turns it into an output" d
          |> Diagnostic.hint
               "combine several commands with `.`: `roMake (setVelTR v omega . setLight On)`")
  | _ -> None

(* The output of a mode without the event that ends it. *)
let output_with_an_event fact =
  match fact.lack.lacking with
  | Declared { name = "RobotOutput"; _ } when is_with_an_event fact.lack.culprit ->
      let at = fact.required.at in
      let written =
        Option.bind
          (Source.text (Wording.sources fact.words) at.file)
          (fun text ->
            Option.bind (Name_in_text.application ~text at) (fun (whole, _) ->
                Option.map (fun output -> (whole, output)) (Wording.quote fact.words whole)))
      in
      let name = name_of_user fact in
      let unknown = if String.equal name "roMake" then "roMake (…)" else name in
      let output = Option.fold written ~none:unknown ~some:snd in
      Some
        (fun d ->
          Diagnostic.message
            "a pair of an output and an event is needed here, but %s returns only an output"
            (user fact)
            { d with here = None; labels = [] }
          |> Diagnostic.hint "return a pair of the output and an event: %s"
               (Switch_mistake.ends_it output)
          |> Option.fold written ~none:Fun.id ~some:(fun (whole, output) ->
                 Diagnostic.write whole (Switch_mistake.with_an_event output)))
  | _ -> None

(* Numbers in place of a robot's output. *)
let output_of_numbers fact =
  let is_number t = match Type.expand t with Type.Number _ -> true | _ -> false in
  let of_numbers =
    match Type.expand fact.lack.culprit with
    | Tuple (_ :: _ as ts) -> List.for_all is_number ts
    | t -> is_number t
  in
  match fact.lack.lacking with
  | Declared { name = "RobotOutput" | "DiffDrive"; _ } when of_numbers ->
      Some
        (Diagnostic.hint "%s"
           (match fact.required.by with
           | Name ("roMake" | "setVelTR") ->
               Printf.sprintf
                 "%s returns commands for a robot: the signature or the other outputs here must \
                  also have the type `RobotOutput`, not %s"
                 (user fact) fact.culprit
           | _ ->
               "a robot takes commands, not numbers: turn the speed and the turn rate into an \
                output with `roMake (setVelTR v omega)`"))
  | _ -> None

(* `Twist { linear = v, angular = 0 }`, a robot command in ROS *)
let twist fact =
  match fact.lack.lacking with
  | Declared { name = "RobotOutput" | "DiffDrive"; _ } ->
      Option.map (Diagnostic.hint "%s")
        (Output_mistake.hint_for_a_twist fact.words fact.lack.culprit)
  | _ -> None

(* Is this type defined in a library module, so that it cannot be the programmer's own robot
   output? *)
let is_of_the_library (t : Ir.Global.t) =
  List.mem t.module_
    [
      "Prelude";
      "Capability";
      "Geometry";
      "Pioneer";
      "Scout";
      "Create";
      "Ros";
      "Vision";
      "Stereo";
      "Display";
      "Tags";
      "Trial";
      "Driving";
    ]

(* The record with neutral values in all fields, such as [Out { speed = 0 }]. *)
let at_rest fact constructor tycon =
  let value (t : Ir.ty) =
    match t with
    | Number _ -> "0"
    | Bool -> "False"
    | Data { tycon = { name = "Event"; _ }; _ } -> "NoEvent"
    | _ -> "…"
  in
  Option.map
    (fun (c : Environment.constructor) ->
      Printf.sprintf "%s { %s }" constructor
        (String.concat ", "
           (List.map (fun (name, ty) -> Printf.sprintf "%s = %s" name (value ty)) c.ir.fields)))
    (Environment.record_of (Wording.environment fact.words) tycon)

(* A record declared by the program, used as a robot's output. *)
let own_output fact =
  match (fact.lack.lacking, Type.expand fact.lack.culprit) with
  | Declared { name = ("RobotOutput" | "DiffDrive") as class_; _ }, Data { tycon; _ }
    when is_asked_itself fact && not (is_of_the_library tycon) ->
      let rest =
        match Wording.fields fact.words fact.lack.culprit with
        | Some (constructor, _) -> at_rest fact constructor tycon
        | None -> None
      in
      Some
        (Diagnostic.hint "%s"
           (match (class_, rest) with
           | "RobotOutput", Some rest ->
               Printf.sprintf
                 "for a robot of your own, define its output at rest: `instance RobotOutput %s \
                  where restingOutput = %s`; for a Pioneer, use the type `RobotOutput`"
                 tycon.name rest
           | "RobotOutput", None ->
               Printf.sprintf
                 "for a robot of your own, define its output at rest: `instance RobotOutput %s \
                  where restingOutput = …`; for a Pioneer, use the type `RobotOutput`"
                 tycon.name
           | _ ->
               Printf.sprintf
                 "for a robot of your own, define how it drives: `instance DiffDrive %s where \
                  setVelTR v omega o = o { … }`; for a Pioneer, use the type `RobotOutput`"
                 tycon.name))
  | _ -> None

(* The pair of outputs that `both` returns for two tasks. *)
let two_outputs fact =
  match fact.lack.lacking with
  | Declared { name = "RobotOutput"; _ } when is_pair fact.lack.culprit ->
      Some
        (Diagnostic.hint
           "`both` returns a pair of outputs: combine them with `mapOutput`, or use `timeOut` or \
            `abortWhen`, which keep only the output of the task")
  | _ -> None

(* The statement `roMake (…)` and its span, if it is alone on its line. *)
let command_line fact =
  let at = fact.required.at in
  Option.bind
    (Source.line (Wording.sources fact.words) at.file (Span.line at.start))
    (fun line ->
      let text = String.trim line in
      let is_alone =
        String.starts_with ~prefix:"roMake (" text && String.ends_with ~suffix:")" text
      in
      let count c = List.length (String.split_on_char c text) in
      if is_alone && count '(' = count ')' && String.length text < 60 then
        let stop = Span.forward (String.length text) at.start in
        Some (text, { at with stop })
      else None)

(* A task in an equation, or a command in place of a task. *)
let task fact =
  match (fact.lack.lacking, command_line fact) with
  | Declared _, _
    when Environment.is_task fact.lack.culprit && Within_proc.is_certain fact.words fact.required.at
    ->
      Some (Diagnostic.hint "%s" (Within_proc.no_tasks None))
  | Declared _, Some (command, at)
    when Environment.is_task fact.lack.culprit && fact.required.by = Name "roMake" ->
      let text = Printf.sprintf "sleepT 1[s] (%s)" command in
      Some
        (fun d ->
          Diagnostic.hint
            "a robot command is not a task: to give it for a fixed time, write `%s`; to give it \
             until an event `e` occurs, write `mkTask (proc i -> (%s, e))`"
            text command d
          |> Diagnostic.write at text)
  | Declared _, _ when Environment.is_task fact.lack.culprit ->
      Some
        (Diagnostic.hint "%s"
           (if fact.required.by = Name "roMake" then
              "a robot command is not a task: in a `do`, write `sleepT 1[s] (roMake …)` to give it \
               for a fixed time, or `mkTask (proc i -> (roMake …, e))` to give it until an event \
               `e` occurs"
            else
              "an equation cannot run a task: run it with `reactimateTask`, or write the tasks one \
               after the other in a `do`"))
  | _ -> None

(* Arithmetic on signal functions, where one operand is a number. *)
let signal_function fact =
  match fact.lack.lacking with
  | Declared { name = "RobotOutput"; _ }
    when is_signal_function fact.lack.culprit && fact.required.by = Name "roMake" ->
      let at = fact.required.at in
      let written =
        Option.bind
          (Source.text (Wording.sources fact.words) at.file)
          (fun text ->
            Option.bind (Name_in_text.application ~text at) (fun (whole, _) ->
                Option.map (fun output -> (whole, output)) (Wording.quote fact.words whole)))
      in
      let text = Option.fold written ~none:"(roMake (…))" ~some:(fun (_, o) -> Source.grouped o) in
      Some
        (fun d ->
          Diagnostic.message "a signal function is needed here, but %s returns an output"
            (user fact)
            { d with here = None; labels = [] }
          |> Diagnostic.hint
               "for a signal function that always returns this output, write `constant %s`" text
          |> Option.fold written ~none:Fun.id ~some:(fun (whole, output) ->
                 Diagnostic.write whole ("(constant " ^ Source.grouped output ^ ")")))
  | Declared _ when is_signal_function fact.lack.culprit ->
      Some (Diagnostic.hint "use `constant e` for a signal function that always returns `e`")
  | _ -> None

(* `==` or `<` on types that do not support it. *)
let not_comparable fact =
  match fact.lack.lacking with
  | Declared _ -> None
  | (Eq | Ord) when (not (is_direct fact)) && is_asked_itself fact ->
      Some
        (fun d ->
          Diagnostic.note "it contains %s" fact.culprit d
          |> about_foreign fact.words fact.lack.culprit)
  | (Eq | Ord) when Type.expand fact.lack.culprit = String ->
      Some
        (Diagnostic.hint
           "a string is only a label: for a choice, declare a type, as in `data Mode = Go | Stop`")
  | Eq | Ord -> Some (about_foreign fact.words fact.lack.culprit)

(* A function that sets an output, used without `roMake`. *)
let output_not_made fact =
  match fact.lack.lacking with
  | Declared { name = "RobotOutput"; _ } when fact.required.by <> Name "roMake" ->
      let hint = Output_mistake.hint_without_instance fact.lack.culprit in
      Some (Option.fold hint ~none:Fun.id ~some:(Diagnostic.hint "%s"))
  | _ -> None

(* `roMake setVelTR . setLight`, where an argument is missing. *)
let composed_without_parentheses fact =
  match fact.lack.lacking with
  | Declared { name = "DiffDrive"; _ } when is_function fact.lack.culprit ->
      Some
        (Diagnostic.hint
           "`.` composes functions: put a function and its arguments in parentheses, as in `roMake \
            (setVelTR v omega)`")
  | _ -> None

(* The number of parameters of a method or function in the module [Capability], including the
   robot. *)
let parameters fact =
  let rec count t =
    match Type.expand t with
    | Type.Function (_, result) -> 1 + count result
    | Signal_function _ -> 1
    | _ -> 0
  in
  let name = name_of_user fact in
  Option.map count (Wording.declared_type fact.words { module_ = "Capability"; name })

let is_of_an_output (class_ : Ir.class_) =
  match class_ with
  | Declared { name = "RobotOutput" | "DiffDrive" | "HasLight" | "HasSound" | "HasDisplay"; _ } ->
      true
  | Declared _ | Eq | Ord -> false

let takes_a_robot fact =
  let by = user fact in
  match (is_of_an_output fact.lack.lacking, parameters fact) with
  | false, Some 1 ->
      let name = String.concat "" (String.split_on_char '`' by) in
      Printf.sprintf "%s takes the robot's input, not %s: in `proc i -> …`, write `%s i`" by
        fact.culprit name
  | false, Some _ ->
      Printf.sprintf
        "the last argument of %s must be the robot's input (the `i` in `proc i -> …`), not %s" by
        fact.culprit
  | true, Some _ ->
      Printf.sprintf
        "the last argument of %s must be the robot's output, not %s: `roMake` supplies it" by
        fact.culprit
  | _, None ->
      Printf.sprintf
        "%s needs a robot's input or output, not %s: check that the robot is the last argument" by
        fact.culprit

(* `mkTask cruise`, where `cruise` returns only an output *)
let mode_without_event fact =
  let at = fact.required.at in
  let before = "mkTask " in
  let column = Span.column at.start - String.length before in
  match Type.expand fact.lack.culprit with
  | Tuple [ _; e ] when Environment.is_event e && column >= 1 ->
      let start = Span.position ~line:(Span.line at.start) ~column in
      let name = name_of_user fact in
      if
        Wording.quote fact.words (Span.make ~file:at.file ~start ~stop:at.stop)
        = Some (before ^ name)
      then
        let fixed = Printf.sprintf "(%s &&& after 10[s])" name in
        Some
          (fun d ->
            Diagnostic.hint
              "`mkTask` needs the output and an event that ends the task: write `mkTask %s`, or \
               use another event"
              fixed d
            |> Diagnostic.write at fixed)
      else None
  | _ -> None

(* Another value in place of a robot's input or output. *)
let of_no_robot fact =
  match fact.lack.lacking with
  | Declared { module_ = "Capability"; _ }
    when is_asked_itself fact && Missing_instance.is_no_robot fact.lack.culprit ->
      Some (Diagnostic.hint "%s" (takes_a_robot fact))
  | _ -> None

(* A missing instance that the program can declare. *)
let not_declared fact =
  match fact.lack.lacking with
  | Declared class_ when is_asked_itself fact && is_of_the_program class_ fact.lack.culprit ->
      Some
        (Diagnostic.hint "add `instance %s where`, and define the methods below it"
           (Wording.constraint_ fact.words fact.lack.lacking fact.lack.culprit))
  | _ -> None

(* Lists the types that have an instance, if there are only a few. *)
let other_instances fact =
  match fact.lack.lacking with
  | Eq | Ord -> None
  | Declared class_ -> (
      match those_with fact.words class_ with
      | _ :: _ as types when is_asked_itself fact && List.compare_length_with types 6 <= 0 ->
          let for_others =
            if String.equal class_.module_ "Capability" then for_any_robot class_ fact.lack.culprit
            else Fun.id
          in
          Some
            (fun d ->
              Diagnostic.note "types with `%s`: %s" class_.name (String.concat ", " types) d
              |> for_others)
      | _ -> None)

(* The first rule that applies is used. Rules for `RobotOutput` and for particular kinds of types
   come before the rules for any class. *)
let rules =
  [
    several_outputs;
    output_with_an_event;
    output_of_numbers;
    twist;
    own_output;
    two_outputs;
    task;
    signal_function;
    not_comparable;
    output_not_made;
    composed_without_parentheses;
    mode_without_event;
    of_no_robot;
    not_declared;
    other_instances;
  ]

let no_instance words required (lack : lack) =
  let culprit = Wording.quoted words lack.culprit in
  let fact = { words; required; lack; culprit } in
  let d = without_hints fact |> where_needed fact in
  let complete = List.find_map (fun rule -> rule fact) rules in
  Option.value complete ~default:Fun.id d

(* {1 Other messages} *)

(* The hint with an example of a condition on the asserted value. It compares a number with a limit
   in the number's own unit. *)
let asserted words ~(at : Span.t) culprit =
  let e = Option.fold (Wording.quote words at) ~none:"x" ~some:Source.grouped in
  match Type.expand culprit with
  | Number (_, u) when not (Units.is_open u) ->
      let unit_ = Wording.measure words u in
      let limit = if String.equal unit_ "1" then "1" else Printf.sprintf "1[%s]" unit_ in
      Printf.sprintf "assert a condition: compare the value with a limit, as in `(%s <= %s)`"
        (Option.value (Wording.quote words at) ~default:"x")
        limit
  | Data { tycon; _ } when tycon = Environment.built_in "Maybe" ->
      Printf.sprintf "assert a condition, such as `(%s /= Nothing)`" e
  | _ -> "assert a condition, such as `x > 0`, or a `Verdict`"

(* Does not mention classes, because the user may not know about them. *)
let not_a_condition words ~at culprit =
  let e = Option.fold (Wording.quote words at) ~none:"e" ~some:Source.grouped in
  Diagnostic.error ~code:"E0360" ~at "%s is not a condition" (Wording.quoted words culprit)
  |> Diagnostic.hint "%s"
       (if Environment.is_event culprit then
          Printf.sprintf "use `isEvent %s`, which is True when the event occurs" e
        else asserted words ~at culprit)

let undecided words (required : required) class_ =
  Diagnostic.error ~code:"E0308" ~at:required.at "nothing determines the type at which %s is used"
    (Required_label.user words required)
  |> Diagnostic.note "the type must have an instance of the class `%s`" (Show.class_ class_)
  |> Diagnostic.hint "add a type annotation, as in `(e :: T)`"
  |> Required_label.add words required

let diagnostic words (fact : Instance_fact.t) =
  match fact with
  | No_instance { required; lack } -> (
      match
        if Environment.is_task lack.culprit then Returned_value.diagnostic words ~at:required.at
        else None
      with
      | Some d -> d
      | None -> no_instance words required lack)
  | Not_a_condition { at; ty } -> not_a_condition words ~at ty
  | Undecided { required; class_ } -> undecided words required class_
  | Unpromised { first; others } -> Promise_mistake.unpromised words first others
