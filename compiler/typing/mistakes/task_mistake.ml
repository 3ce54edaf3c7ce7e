open Basis
open Diagnostic

let is_proc (e : Resolve.Ir.expr) = match e.desc with Proc _ -> true | _ -> false

(* The input and the output of a [proc], if they are short. *)
let parts words (e : Resolve.Ir.expr) =
  match e.desc with
  | Proc { input; body = { output; _ } } ->
      let quote at otherwise = Option.value (Show.quote words at) ~default:otherwise in
      (quote input.span "x", quote output.span "output")
  | _ -> ("x", "output")

(* `delay(1000)`, as if it waited: what it is given. *)
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
    | Number { unit_ = Some _; _ } -> Option.value (Show.quote words argument.span) ~default:"1[s]"
    | _ -> "1[s]"
  in
  hint
    (Printf.sprintf
       "`delay` is the value of a signal one instant ago; a task that waits is `sleepT %s \
        restingOutput`, with the robot at rest"
       how_long)

(* How a signal function becomes a task: it ends at its event, or never. *)
let to_task words subject output =
  let name = match Option.bind subject Plain_name.of_expr with Some name -> name | None -> "sf" in
  match Type.expand output with
  | Tuple [ _; last ] when Environment.is_event last ->
      hint (Printf.sprintf "`mkTask %s` is the task that ends when its event occurs" name)
  | _ when Option.fold subject ~none:false ~some:is_proc ->
      let input, output = parts words (Option.get subject) in
      hint
        (Printf.sprintf
           "a task ends at an event, which its `proc` gives beside the output: `mkTask (proc %s -> \
            (%s, after 1[s] ()))`; one with `never ()` in that place goes on for ever"
           input output)
  | _ ->
      hint
        (Printf.sprintf
           "`mkTask (%s &&& event)` ends when the event occurs; `mkTask (%s &&& never)` never does"
           name name)

let task_and_signal_function words ~subject ~at ~(expected : Expected.t) ~found =
  match Type.expand found with
  | Signal_function (_, output) -> (
      error ~code:"E0371" ~at "a signal function stands where a task is needed"
      |> here (Printf.sprintf "this is %s" (Show.described words found))
      |> (match expected.because with
         | Statement _ when Option.bind subject Plain_name.of_expr <> None ->
             let name = Option.get (Option.bind subject Plain_name.of_expr) in
             hint (Printf.sprintf "to read it once: `ask %s`" name)
         | Parameter { callee = Some "reactimateTask"; _ } ->
             hint "`reactimateRobot` makes a program of a signal function"
         | _ -> Fun.id)
      |>
      match Option.bind subject (waits expected) with
      | Some argument -> to_wait words argument
      | None -> to_task words subject output)
  | _ ->
      let name =
        match Option.bind subject Plain_name.of_expr with Some name -> name | None -> "t"
      in
      error ~code:"E0371" ~at "a task stands where a signal function is needed"
      |> here (Printf.sprintf "this is %s" (Show.described words found))
      |> hint
           (match expected.because with
           | Parameter { callee = Some "reactimateRobot"; _ } ->
               Printf.sprintf "`reactimateTask %s` makes a program of a task" name
           | _ ->
               Printf.sprintf
                 "`runTask %s` is a signal function: `Left` its output while it runs, then `Right` \
                  its result"
                 name)

(* Two tasks that differ in one thing. *)
let unlike_tasks words ~at ~(because : Expected.reason) (input, output, result)
    (input', output', result') =
  let differ a b =
    match Type.expand a with
    | Flexible _ -> false
    | _ -> not (String.equal (Show.described words a) (Show.described words b))
  in
  let says format a b =
    Some (Printf.sprintf format (Show.described words a) (Show.described words b))
  in
  let nothing t = Type.expand t = Tuple [] in
  let cure = ref Fun.id in
  let text =
    match (differ input input', differ output output', differ result result') with
    | false, false, true ->
        cure :=
          if nothing result then
            hint
              "`mapT (const ()) t` is the task `t` without its result; in a `do`, `return ()` \
               below it drops it"
          else if nothing result' then hint "in a `do`, `return x` below it ends the two with `x`"
          else hint "`mapT f t` is the task `t`, and ends with `f` of its result";
        says "expected a task that ends with %s, but this one ends with %s" result result'
    | false, true, false ->
        says "expected a task whose output is %s, but that of this one is %s" output output'
    | true, false, false ->
        (match because with
        | Parameter { callee = Some "watching"; _ } ->
            cure :=
              hint
                "`watching` adds to the input what is heard; a task of any input has the \
                 capabilities in its signature: `(HasSonar i, DiffDrive o) => Task i o Bool`"
        | _ -> ());
        says "expected a task whose input is %s, but that of this one is %s" input input'
    | _ -> None
  in
  Option.map (fun text -> error ~code:"E0301" ~at "%s" text |> !cure) text

let no_task words ~subject ~at ~found =
  error ~code:"E0370" ~at "the statements of a `do` are tasks, but this is %s"
    (Show.described words found)
  |> hint
       (match Option.bind subject Plain_name.of_expr with
       | Some name -> Printf.sprintf "`return %s` is the task that ends at once with it" name
       | None -> "`let x = …` names a value; `return x` is the task that ends at once with it")

let beside_each_other (expected : Expected.t) =
  match expected.because with
  | Parameter { callee = Some ("||" | "&&"); _ } | Operand { operator = "||" | "&&"; _ } ->
      Some
        "two tasks are done side by side by `both s t`, and one until something happens by \
         `abortWhen`; one after the other they stand in a `do`"
  | _ -> None
