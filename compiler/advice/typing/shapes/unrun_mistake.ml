open Basis
open Typing
open Diagnostic

(* Signal functions of the prelude whose only argument before the signal is their initial output. *)
let has_initial_value = function
  | "delay" | "hold" | "dHold" | "accum" | "accumHold" | "dAccumHold" -> true
  | _ -> false

let count = function
  | 1 -> "one argument"
  | 2 -> "two arguments"
  | n -> Printf.sprintf "%d arguments" n

let rec arguments_of (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply { head; argument; style = Juxtaposed } -> arguments_of head @ [ argument ]
  | _ -> []

(* The signal to suggest as the input of a signal function. *)
let signal_for words input =
  match Type.expand input with
  | Tuple [] -> "()"
  | Flexible _ when not (Wording.needs_class words input) -> "()"
  | _ -> Option.value (Wording.signal words input) ~default:"x"

(* Does the expression mention a local name outside the operands of operators? *)
let rec is_a_signal (e : Resolve.Ir.expr) =
  match e.desc with
  | Local _ -> true
  | Apply { head; argument; style = Juxtaposed } -> is_a_signal head || is_a_signal argument
  | _ -> false

let has_signal e =
  match List.rev (arguments_of e) with last :: _ -> is_a_signal last | [] -> false

(* `delay(0, x)`, whose initial value and signal form one tuple. *)
let in_one_tuple (e : Resolve.Ir.expr) =
  match (Plain_name.of_head e, arguments_of e) with
  | Some name, [ { desc = Tuple ([ _; _ ] as parts); _ } ] when has_initial_value name ->
      Some (name, parts)
  | _ -> None

(* [f 1 x], where [f 1 y x] was meant. *)
let signal_in_place_of_an_argument words name arguments =
  match List.rev_map (fun (e : Resolve.Ir.expr) -> (e, Wording.quote words e.span)) arguments with
  | (last, Some signal) :: before when before <> [] && is_a_signal last ->
      let before =
        List.rev_map (fun (_, text) -> Option.fold text ~none:"…" ~some:Source.grouped) before
      in
      Some
        (Printf.sprintf "`%s` takes %s before its signal: write `%s`, where the signal is `%s`" name
           (count (List.length arguments))
           (String.concat " " ((name :: before) @ [ "…"; Source.grouped signal ]))
           signal)
  | _ -> None

(* The fix that replaces the expression with this application. The parentheses are needed because
   the expression may be an argument. *)
let instead (e : Resolve.Ir.expr option) text d =
  match e with
  | Some e -> fix (Printf.sprintf "write `%s`" text) [ (e.span, "(" ^ text ^ ")") ] d
  | None -> d

(* The definition of the subject, if the subject is a local name for the application of a signal
   function, such as `hysteresis 1 x` for `far` in `far = hysteresis 1 x`. Otherwise, the subject
   itself. *)
let meant words (subject : Resolve.Ir.expr option) =
  match subject with
  | Some { desc = Local x; _ } -> (
      match Wording.definition words x with
      | Some ({ desc = Apply { style = Juxtaposed; _ }; _ } as e)
        when Plain_name.of_head e <> None && (has_signal e || in_one_tuple e <> None) ->
          Some e
      | Some ({ desc = Global _; _ } as e) -> Some e
      | _ -> subject)
  | _ -> subject

(* Is this an input of the enclosing proc, and not an event? *)
let is_no_event words (x : Resolve.Ir.Local.t) =
  match List.assoc_opt x.name (Wording.inputs words) with
  | Some t -> ( match Type.expand t with Number _ | Bool | Tuple _ -> true | _ -> false)
  | None -> false

(* An initial value for a signal of this type, or, for an event, for the value that it carries. *)
let rec initial t =
  match Type.expand t with
  | Type.Number _ -> "0"
  | Bool -> "False"
  | Data { arguments = [ value ]; _ } when Environment.is_event t -> initial value
  | _ -> "x0"

(* The argument in Frob notation *)
let rewritten words (e : Resolve.Ir.expr) =
  match Wording.quote words e.span with
  | Some text -> Source.grouped (Option.value (Other_notation.expression text) ~default:text)
  | None -> "…"

let hint_to_run words subject ~wanted input d =
  let where =
    match subject with
    | Some ({ desc = Local x; _ } : Resolve.Ir.expr) when meant words subject <> subject ->
        Some x.name
    | Some _ | None -> None
  in
  let subject = meant words subject in
  let signal = signal_for words input in
  let arguments = Option.fold subject ~none:[] ~some:arguments_of in
  let argument = function
    | ({ span; _ } : Resolve.Ir.expr) ->
        Option.fold (Wording.quote words span) ~none:"…" ~some:Source.grouped
  in
  hint "%s"
    (match (Option.bind subject Plain_name.of_head, arguments) with
    | Some (("hold" | "dHold") as name), [ ({ desc = Local x; _ } as only) ]
      when is_no_event words x ->
        Printf.sprintf
          "`%s` keeps the value of an event, as in `%s x0 e`, but `%s` has a value at every \
           instant: write `%s` alone"
          name name x.name (argument only)
    | Some _, _ when Option.bind subject in_one_tuple <> None ->
        let name, parts = Option.get (Option.bind subject in_one_tuple) in
        Printf.sprintf "write the arguments without parentheses or commas: `%s`"
          (String.concat " " (name :: List.map (rewritten words) parts))
    | Some name, [ only ] when has_initial_value name ->
        let start =
          match (name, Type.expand input) with
          | "delay", Flexible _ -> initial wanted
          | _ -> initial input
        in
        Printf.sprintf "`%s` takes an initial value before its signal: write `%s %s %s`" name name
          start (argument only)
    | Some name, _ :: _ -> (
        match signal_in_place_of_an_argument words name arguments with
        | Some text -> text
        | None ->
            Printf.sprintf "add %s as the last argument: `%s %s`"
              (if signal = "()" then "`()`" else "a signal")
              (String.concat " " (name :: List.map argument arguments))
              signal)
    | Some name, [] when where <> None ->
        Printf.sprintf "run the signal function on `%s` in its definition: `%s = %s %s`" signal
          (Option.get where) name signal
    | Some name, [] -> Printf.sprintf "run the signal function on `%s`: `%s %s`" signal name signal
    | None, _ -> Printf.sprintf "run the signal function on `%s`" signal)
    d
  |>
  match (Option.bind subject Plain_name.of_head, arguments) with
  | Some name, [] -> instead subject (Printf.sprintf "%s %s" name signal)
  | _ -> Fun.id

(* `after 5[s]` used as a condition. *)
let truth_of_event words ~(subject : Resolve.Ir.expr option) ~wanted ~found =
  let text = Option.bind subject (fun (e : Resolve.Ir.expr) -> Wording.quote words e.span) in
  match (Type.expand wanted, Type.expand found, subject, text) with
  | Type.Bool, Type.Signal_function (input, output), Some e, Some text
    when Environment.is_event output -> (
      let signal = signal_for words input in
      match (Plain_name.of_head e, arguments_of e) with
      | Some "after", [ q ] ->
          Some (Printf.sprintf "elapsed %s ()" (Wording.argument_or "q" words q))
      | _ -> Some (Printf.sprintf "isEvent (%s %s)" text signal))
  | _ -> None

(* The hint for a signal function of the robot, such as `frontSonar`, that is not applied to a
   signal, or for a name defined as such a function, as in `let x = frontSonar`. Either the `proc`
   has no name for its input, or the code is probably in a task. *)
let sense_without_input words ~(subject : Resolve.Ir.expr option) input =
  let is_robot = Wording.needs_class words input in
  match subject with
  | Some { desc = Global { name; _ }; _ }
    when is_robot && Wording.inputs words = [] && Wording.unnamed_input words <> None ->
      Some
        (Printf.sprintf "give the input of the `proc` a name, `proc i -> …`, and write `%s i` here"
           name)
  | Some { desc = Local x; _ } when Wording.inputs words = [] && is_robot -> (
      match Option.bind (Wording.definition words x) Plain_name.of_expr with
      | Some sf ->
          Some
            (Printf.sprintf
               "in a task, first read the current value: write `%s <- ask %s` in place of `let %s \
                = %s`"
               x.name sf x.name sf)
      | None -> None)
  | Some { desc = Global { name; _ }; _ } when Wording.inputs words = [] && is_robot ->
      Some
        (Printf.sprintf
           "in a task, first read the current value with `x <- ask %s`, then write `x` here" name)
  | _ -> None

let message words ~subject ~at ~wanted ~input ~found =
  let d =
    error ~code:"E0303" ~at
      "expected a value, found a signal function that is not applied to a signal"
    |> here "this is %s" (Wording.described words found)
  in
  match truth_of_event words ~subject ~wanted ~found with
  | Some fixed ->
      hint "its output is an event: to use the event as a condition, write `%s`" fixed d
      |> instead subject fixed
  | None -> (
      let d =
        match (subject, meant words subject) with
        | Some { desc = Local x; _ }, Some e when Some e <> subject ->
            Reason_label.defines ~at:e.span x.name d
        | _ -> d
      in
      match sense_without_input words ~subject input with
      | Some text -> hint "%s" text d
      | None -> hint_to_run words subject ~wanted input d)

(* Programs are built from signal functions that are not applied to a signal. *)
let is_program ty =
  match Type.expand ty with
  | Type.Data { tycon; _ } -> tycon = Environment.built_in "Program"
  | _ -> false

let program (fact : Shape_fact.t) =
  let d =
    error ~code:"E0301" ~at:fact.at "expected a program, found a signal function"
    |> here "this is %s" (Shape_fact.found_text fact)
    |> note "expected %s" (Shape_fact.expected_text fact)
  in
  let text =
    Option.bind fact.subject (fun (e : Resolve.Ir.expr) -> Wording.quote fact.words e.span)
  in
  match text with
  | None -> hint "use `reactimateRobot` to turn a signal function into a program" d
  | Some text ->
      let made = "reactimateRobot " ^ Source.grouped text in
      d |> hint "write `%s`" made |> instead fact.subject made

(* A program whose `proc` has the input `()`, although the robot has an input. *)
let program_without_input (fact : Shape_fact.t) =
  let is_unit t = Type.expand t = Type.Tuple [] in
  match (fact.wanted, fact.given, fact.subject) with
  | ( Data { tycon; arguments = wanted :: _; _ },
      Data { tycon = tycon'; arguments = given :: _; _ },
      Some
        {
          desc =
            Apply { argument = { desc = Proc { input = { desc = Tuple_of []; span }; _ }; _ }; _ };
          _;
        } )
    when tycon = Environment.built_in "Program"
         && tycon' = tycon && is_unit given
         && not (is_unit wanted) ->
      error ~code:"E0301" ~at:span "expected the input %s, found `()`"
        (Wording.described fact.words wanted)
      |> hint "if the program does not use its input, write `proc _ -> …`"
      |> write span "_" |> Option.some
  | _ -> None

(* `neverTouches && endsWithin 15[s]` as the judge of a trial *)
let two_judges (fact : Shape_fact.t) =
  let is_a_verdict t =
    match Type.expand t with Type.Data { tycon; _ } -> tycon.name = "Verdict" | _ -> false
  in
  match (fact.given, fact.expected.because) with
  | Signal_function (_, output), Parameter { callee = Some "&&"; given = [ a; b ]; position = 1; _ }
    when is_a_verdict output -> (
      let quote = Wording.argument fact.words in
      match (quote a, quote b) with
      | Some f, Some g ->
          let text = Printf.sprintf "bothOf %s %s" f g in
          Some
            (Shape_fact.hinted fact "to require two verdicts, write `%s`" text
            |> write (Span.merge a.span b.span) text)
      | _ -> None)
  | _ -> None

let unrun (fact : Shape_fact.t) =
  match (fact.wanted, fact.given) with
  | Bool, Signal_function _ when two_judges fact <> None -> two_judges fact
  | Data _, Signal_function _ when is_program fact.expected.ty -> Some (program fact)
  | (Number _ | Bool | String | Tuple _ | Data _ | Rigid _), Signal_function (input, _) ->
      message fact.words ~subject:fact.subject ~at:fact.at ~wanted:fact.expected.ty ~input
        ~found:fact.found
      |> note "expected %s" (Shape_fact.expected_text fact)
      |> Option.some
  | _ -> None

let unrun_operand (fact : Shape_fact.t) =
  match (fact.wanted, fact.given, Shape_fact.other_operand fact) with
  | Signal_function (input, _), (Number _ | Bool | String | Tuple _ | Data _ | Rigid _), Some other
    ->
      message fact.words ~subject:(Some other) ~at:other.span ~wanted:fact.found ~input
        ~found:fact.expected.ty
      |> label ~at:fact.at "this is %s" (Shape_fact.found_text fact)
      |> Option.some
  | _ -> None

let program_in_place_of_a_signal_function (fact : Shape_fact.t) =
  match (fact.wanted, Shape_fact.callee fact) with
  | Signal_function _, _ when is_program fact.found ->
      let maker =
        match Option.bind fact.subject Plain_name.of_head with
        | Some maker -> Printf.sprintf ", or remove `%s` to leave only the signal function" maker
        | None -> ""
      in
      Some
        (Shape_fact.hinted fact
           "this is a program: write its type as `Program RobotInput RobotOutput`%s" maker)
  | _ -> None
