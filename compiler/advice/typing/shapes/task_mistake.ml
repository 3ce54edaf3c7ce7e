open Basis
open Typing
open Diagnostic
open Shape_fact

(* The source texts of a [proc]'s input and output, or names for them if they are long. *)
let parts words (e : Resolve.Ir.expr) =
  match e.desc with
  | Proc { input; body = { output; _ } } ->
      let quote at otherwise = Option.value (Wording.quote words at) ~default:otherwise in
      Some (quote input.span "x", quote output.span "output")
  | _ -> None

(* The argument of `delay` in a statement such as `delay(1000)`, which was meant to wait. *)
let waits (expected : Expected.t) (e : Resolve.Ir.expr) =
  match (expected.because, e.desc) with
  | ( (Statement _ | Last_statement _),
      Apply { head = { desc = Global { module_ = "Prelude"; name = "delay" }; _ }; argument; _ } )
    ->
      Some argument
  | _ -> None

let to_wait words (argument : Resolve.Ir.expr) =
  let how_long =
    match argument.desc with
    | Number { unit_ = Some _; _ } ->
        Option.value (Wording.quote words argument.span) ~default:"1[s]"
    | _ -> "1[s]"
  in
  hint
    "to wait with the robot at rest, write `sleepT %s restingOutput`; `delay` returns the previous \
     value of a signal"
    how_long

(* How to turn a signal function into a task that ends at an event, or into one that never ends. *)
let to_task words (subject : Resolve.Ir.expr option) output =
  let text = Option.bind subject (fun (e : Resolve.Ir.expr) -> Wording.quote words e.span) in
  let name = Option.value text ~default:"sf" in
  match Type.expand output with
  | Tuple [ _; last ] when Environment.is_event last ->
      hint "use `mkTask %s`, which ends when its event occurs" (Source.grouped name)
  | _ -> (
      match Option.bind subject (parts words) with
      | Some (input, output) ->
          hint
            "add the event that ends the task: `mkTask (proc %s -> (%s, after 1[s] ()))`; with \
             `never ()` as the event, it never ends"
            input output
      | None ->
          hint
            "to run it for a fixed time, write `mkTask (%s &&& after 5[s])`; to run it forever, \
             `mkTask (%s &&& never)`"
            name name)

(* Is this probably the type of a robot's output? *)
let is_an_output words t =
  Wording.needs_class words t
  ||
  match Type.expand t with
  | Data { tycon; _ } -> String.ends_with ~suffix:"Output" tycon.name
  | _ -> false

let in_place_of_a_task fact output =
  error ~code:"E0371" ~at:fact.at "expected a task, found a signal function"
  |> here "this is %s" (found_text fact)
  |> (match (fact.expected.because, name fact) with
     | Statement _, Some name when not (is_an_output fact.words output) ->
         hint "to read it once, write `ask %s`" name
     | Parameter { callee = Some "reactimateTask"; _ }, _ ->
         hint "use `reactimateRobot` to turn a signal function into a program"
     | _ -> Fun.id)
  |>
  match Option.bind fact.subject (waits fact.expected) with
  | Some argument -> to_wait fact.words argument
  | None -> to_task fact.words fact.subject output

(* `switch (proc i -> …) (\_ -> turnBy 90[deg])`, or `switch` between two tasks *)
let of_a_switch fact given ~position =
  let rec body (e : Resolve.Ir.expr) =
    match e.desc with Lambda { body = e; _ } -> body e | _ -> e
  in
  let quote e = Wording.quote fact.words (body e).span in
  match (position, List.map quote given) with
  | 1, [ Some first; Some second ] ->
      Printf.sprintf
        "`switch` changes between signal functions: to run one task after the other, write `%s` \
         and `%s` on separate lines below a `do`"
        first second
  | 2, _ ->
      Printf.sprintf
        "`switch` continues with a signal function: to continue with a task, use a `do` instead, \
         with `mkTask (…)` around the first argument of `switch` on its first line and `%s` on its \
         second; `reactimateTask` turns the `do` into a program"
        (raw fact "the task")
  | _ ->
      "`switch` changes between signal functions: to run one task after the other, write each task \
       on its own line below a `do`"

let in_place_of_a_signal_function fact =
  let name = Option.value (name fact) ~default:"t" in
  error ~code:"E0371" ~at:fact.at "expected a signal function, found a task"
  |> here "this is %s" (found_text fact)
  |> hint "%s"
       (match fact.expected.because with
       | Parameter { callee = Some "reactimateRobot"; _ } ->
           Printf.sprintf "use `reactimateTask %s` to turn a task into a program" name
       | Parameter { callee = Some ("switch" | "dSwitch"); given; position; _ } ->
           of_a_switch fact given ~position
       | _ ->
           Printf.sprintf
             "use `runTask %s`, a signal function that returns `Left` with the output while the \
              task runs, then `Right` with the result"
             name)

let task_or_signal_function fact =
  match (fact.wanted, fact.given) with
  | wanted, Signal_function (_, output) when Environment.is_task wanted ->
      Some (in_place_of_a_task fact output)
  | Signal_function _, given when Environment.is_task given ->
      Some (in_place_of_a_signal_function fact)
  | _ -> None

(* `p <- place`, where `place` takes the robot's input. *)
let function_of_the_input fact =
  match (fact.given, name fact) with
  | Function (_, result), Some name
    when is_statement fact && match Type.expand result with Function _ -> false | _ -> true ->
      error ~code:"E0370" ~at:fact.at
        "each statement in a `do` must be a task, but this is a function"
      |> here "this is %s" (found_text fact)
      |> hint "%s"
           (match name with
           | "place" -> "write `robotPlace`, a task that returns the robot's position"
           | _ -> Printf.sprintf "to apply it to the input once, write `ask (arr %s)`" name)
      |> write fact.at
           (if String.equal name "place" then "robotPlace" else Printf.sprintf "ask (arr %s)" name)
      |> Option.some
  | _ -> None

let statement_without_task fact =
  match fact.given with
  | (Number _ | Bool | String | Tuple _ | Data _ | Rigid _)
    when Environment.is_task fact.wanted
         && (not (Environment.is_task fact.given))
         && is_statement fact ->
      error ~code:"E0370" ~at:fact.at "each statement in a `do` must be a task, but this is %s"
        (found_text fact)
      |> hint "%s"
           (match name fact with
           | Some name ->
               Printf.sprintf "use `return %s` for a task that returns it immediately" name
           | None ->
               "use `let x = …` to name a value, or `return x` for a task that returns it \
                immediately")
      |> Option.some
  | _ -> None

(* `[forward 1[m], turnBy 90[deg]]` in place of a task *)
let of_an_array fact =
  match fact.given with
  | Data { arguments = [ _; element ]; _ }
    when Environment.is_task fact.wanted && Array_mistake.is_array fact.found
         && Environment.is_task element ->
      let written =
        match fact.subject with
        | Some { desc = Local x; _ } -> Wording.definition fact.words x
        | Some ({ desc = Global g; _ } as e) -> (
            match Wording.binding fact.words g with
            | Some { parameters = []; body = { guards = [ { value; _ } ]; _ }; _ } -> Some value
            | Some _ | None -> Some e)
        | subject -> subject
      in
      let tasks =
        match written with
        | Some { desc = Array tasks; _ } ->
            all (List.map (fun (e : Resolve.Ir.expr) -> Wording.quote fact.words e.span) tasks)
        | Some _ | None -> None
      in
      Some
        (hinted fact "%s"
           (match tasks with
           | Some (first :: second :: _) ->
               Printf.sprintf
                 "to run tasks one after the other, write each task on its own line below a `do`: \
                  `%s`, `%s`"
                 first second
           | _ -> "to run tasks one after the other, write each task on its own line below a `do`"))
  | _ -> None

let beside_each_other fact =
  match fact.expected.because with
  | (Parameter { callee = Some ("||" | "&&"); _ } | Operand { operator = "||" | "&&"; _ })
    when fact.wanted = Bool && Environment.is_task fact.given ->
      Some
        (hinted fact
           "use `both s t` to run two tasks in parallel, `abortWhen` to end a task at an event, or \
            a `do` to run them one after the other")
  | _ -> None

(* Is this the type of a bare `return`, which fits any task? *)
let is_only_returned words t =
  match Environment.as_task t with
  | Some (input, output, _) -> (
      match (Type.expand input, Type.expand output) with
      | Flexible _, Flexible _ ->
          not (Wording.needs_class words input || Wording.needs_class words output)
      | _ -> false)
  | None -> false

(* `do`, `let` and `return` in the definition of a value *)
let without_tasks fact =
  match fact.subject with
  | Some { desc = Sequence { statements; result }; _ } -> (
      let equations : Resolve.Ir.statement -> Resolve.Ir.binding list option = function
        | Values { groups; _ } ->
            Some (List.concat_map (fun (g : Resolve.Ir.binding_group) -> g.bindings) groups)
        | Task _ -> None
      in
      let all_equations = List.map equations statements in
      match result.desc with
      | Apply { head = { desc = Global { name = "return"; _ }; _ }; argument; _ }
        when not (List.mem None all_equations) -> (
          let bindings = List.concat (List.filter_map Fun.id all_equations) in
          let texts =
            List.map (fun (b : Resolve.Ir.binding) -> Wording.quote fact.words b.span) bindings
          in
          match (Wording.quote fact.words argument.span, Shape_fact.all texts) with
          | Some value, Some (_ :: _ as texts) ->
              Some
                (Printf.sprintf
                   "`do` and `return` are only for tasks: end the line with `= %s where`, and put \
                    %s below it"
                   value
                   (Enumeration.all (List.map (Printf.sprintf "`%s`") texts)))
          | _ -> None)
      | _ -> None)
  | Some _ | None -> None

(* `near d e = return d < e` *)
let returned fact =
  let value =
    match fact.subject with
    | Some { desc = Local x; _ } -> Wording.definition fact.words x
    | Some ({ desc = Global _ | Apply { style = Juxtaposed; _ }; _ } as e) -> (
        match Resolve.Walk.application e with
        | { desc = Global g; _ }, _ when not (Returned_value.is_returned e) -> (
            match Wording.binding fact.words g with
            | Some { body = { guards = [ { value; _ } ]; _ }; _ } -> Some value
            | Some _ | None -> Some e)
        | _ -> Some e)
    | subject -> subject
  in
  let at =
    match value with Some e when Returned_value.is_returned e -> e.span | Some _ | None -> fact.at
  in
  if Environment.is_task fact.wanted <> Environment.is_task fact.given && not (is_statement fact)
  then
    Option.map
      (fun d -> if Span.compare at fact.at = 0 then d else label ~at:fact.at "it is used here" d)
      (Returned_value.diagnostic fact.words ~at)
  else None

let only_returned fact =
  match fact.wanted with
  | (Number _ | Bool | Data _ | Tuple (_ :: _))
    when is_only_returned fact.words fact.given
         && (not (Environment.is_task fact.wanted))
         && without_tasks fact <> None ->
      Some (hinted fact "%s" (Option.get (without_tasks fact)))
  | (Number _ | Bool | Data _ | Tuple (_ :: _))
    when is_only_returned fact.words fact.given && not (Environment.is_task fact.wanted) ->
      Some
        (match Option.map (Bare_number.value fact.words) fact.subject with
        | Some
            {
              desc =
                Apply
                  {
                    head = { desc = Global { name = "return"; _ }; span; _ };
                    argument;
                    style = Juxtaposed;
                  };
              span = whole;
            }
          when Wording.quote fact.words argument.span <> None ->
            let value = Option.get (Wording.quote fact.words argument.span) in
            error ~code:"E0301" ~at:span "`return` is only for tasks"
            |> hint "remove `return`: write `%s`" value
            |> write whole (Source.grouped value)
        | _ ->
            hinted fact
              "`return` is only for tasks: write the value after the `=`, without `return`")
  | _ -> None

(* Is the subject an argument of a function that also takes a task, such as `timeOut`? *)
let is_beside_a_task fact =
  let rec takes_a_task t =
    match Type.expand t with
    | Type.Function (parameter, result) -> Environment.is_task parameter || takes_a_task result
    | _ -> false
  in
  match fact.expected.because with
  | Parameter { head = Some { desc = Global g; _ }; _ } ->
      Option.fold (Wording.declared_type fact.words g) ~none:false ~some:takes_a_task
  | _ -> false

(* `main = watching tour` *)
let in_place_of_a_program fact =
  match (fact.wanted, fact.subject) with
  | Data { tycon; _ }, Some e
    when tycon = Environment.built_in "Program" && Environment.is_task fact.given ->
      let text = Wording.argument fact.words e in
      let fixed = "reactimateTask " ^ Option.value text ~default:"(…)" in
      let d = hinted fact "to turn the task into a program, write `%s`" fixed in
      Some (if text = None then d else write e.span fixed d)
  | _ -> None

(* `out = turnBy 90[deg]` in a `proc` *)
let in_a_proc fact (e : Resolve.Ir.expr) =
  let task text = Some (hinted fact "%s" (Within_proc.no_tasks text)) in
  match e.desc with
  | Local x ->
      Option.bind (Wording.definition fact.words x) (fun (value : Resolve.Ir.expr) ->
          Option.map
            (label ~at:value.span "this is a task")
            (task
               (match value.desc with
               | Apply _ | Global _ -> Wording.quote fact.words value.span
               | _ -> None)))
  | Apply _ | Global _ -> task (Wording.quote fact.words e.span)
  | _ -> None

(* a task where its result is expected, written out or named, as in `let d = ask frontSonar` *)
let in_place_of_its_result fact =
  match (fact.wanted, fact.subject) with
  | (Number _ | Bool | Tuple (_ :: _) | Data _), Some e
    when (match fact.expected.because with Condition -> false | _ -> not (is_beside_a_task fact))
         && Environment.is_task fact.given
         && (not (Environment.is_task fact.wanted))
         && not (is_only_returned fact.words fact.given) -> (
      let run name text = Printf.sprintf "%s <- %s" name text in
      match e.desc with
      | _ when Within_proc.is_certain fact.words e.span -> in_a_proc fact e
      | Local x -> (
          match Wording.definition fact.words x with
          | Some value when Span.line value.span.start >= Span.line x.span.start ->
              Option.map
                (fun text ->
                  hinted fact "run the task: write `%s` in place of `let %s = %s`" (run x.name text)
                    x.name text
                  |> label ~at:value.span "this task is named here, but not run")
                (Wording.quote fact.words value.span)
          | Some _ | None -> None)
      | Apply _ | Global _ ->
          Option.map
            (fun text ->
              hinted fact
                "in a `do`, run the task with `%s` on the line before this one, and use `x` here"
                (run "x" text))
            (Wording.quote fact.words e.span)
      | _ -> None)
  | _ -> None

(* `repeatT (do …)` without a count *)
let without_count fact =
  match fact.expected.because with
  | Parameter
      {
        callee = Some (("repeatT" | "retryT" | "recover" | "retryBackoff") as f);
        position = 1;
        at;
        _;
      }
    when Environment.is_task fact.given ->
      let counted = f ^ " 4" in
      let d =
        different fact
        |> hint ~topic:(Call f) "the number of times comes first: write `%s (…)`%s" counted
             (if String.equal f "repeatT" then "; to repeat endlessly, use `forever`" else "")
        |> write at counted
      in
      Some d
  | _ -> None

let condition fact =
  match fact.expected.because with
  | Condition when Environment.is_task fact.found ->
      let defined =
        match fact.subject with
        | Some { desc = Local x; _ } ->
            Option.bind (Wording.definition fact.words x) (fun (e : Resolve.Ir.expr) ->
                Option.map (fun text -> (x.name, text)) (Wording.quote fact.words e.span))
        | Some _ | None -> None
      in
      not_a_condition fact
      |> hint "%s"
           (match defined with
           | Some (name, task) ->
               Printf.sprintf "run the task: write `%s <- %s` in place of `let %s = %s`" name task
                 name task
           | None ->
               Printf.sprintf
                 "run the task with `ok <- %s` on the line before this one, and write `ok` here"
                 (raw fact "t"))
      |> Option.some
  | _ -> None

(* {1 Two tasks whose types differ in one part} *)

let of_another_result fact result result' =
  let returns_nothing =
    match fact.subject with
    | Some
        {
          desc = Apply { head = { desc = Global { name = "return"; _ }; _ }; argument; style = _ };
          _;
        } -> (
        match argument.desc with Tuple [] -> true | _ -> false)
    | Some _ | None -> false
  in
  let nothing t = Type.expand t = Type.Tuple [] in
  if nothing result then
    Printf.sprintf
      "to drop the result of %s task, write `mapT (const ()) %s`; in a `do`, you can also write \
       `return ()` below it"
      (match raw fact "" with "" -> "the" | _ -> "this")
      (grouped fact "t")
  else if returns_nothing then
    match (Type.expand result, Wording.choices fact.words result) with
    | Bool, _ -> "return a `Bool` here: `return True` or `return False`"
    | _, choice :: _ ->
        Printf.sprintf "return a value of that type here, such as `return %s`" choice
    | _ -> "write the result in place of `()`: `return x`"
  else if nothing result' then "to return `x` instead, write a `do` with `return x` below the task"
  else "to apply a function `f` to the result of a task `t`, write `mapT f t`"

let of_another_input fact d =
  match fact.expected.because with
  | Parameter { callee = Some "watching"; _ } ->
      hint
        "`watching` adds a value to the input, so the task must accept any input with the \
         capabilities that it uses: `(HasSonar i, DiffDrive o) => Task i o Bool`"
        d
  | _ -> d

let unlike fact =
  let text = Wording.described fact.words in
  let differ a b =
    match Type.expand a with Flexible _ -> false | _ -> not (String.equal (text a) (text b))
  in
  let says format a b = error ~code:"E0301" ~at:fact.at format (text a) (text b) in
  match (Environment.as_task fact.expected.ty, Environment.as_task fact.found) with
  | Some (input, output, result), Some (input', output', result') -> (
      match (differ input input', differ output output', differ result result') with
      | false, false, true ->
          says "expected a task that returns %s, but this one returns %s" result result'
          |> hint "%s" (of_another_result fact result result')
          |> Option.some
      | false, true, false ->
          Some
            (says "expected a task with the output %s, but this one has the output %s" output
               output')
      | true, false, false ->
          says "expected a task with the input %s, but this one has the input %s" input input'
          |> of_another_input fact |> Option.some
      | _ -> None)
  | _ -> None
