open Basis
open Typing
open Typing.Ir

let rec runs_a_local (h : expr) =
  match h.desc with Local _ -> true | Apply (f, _) -> runs_a_local f | _ -> false

let complaint (region : Level_fact.region) what =
  match region with
  | Head { head = { desc = Apply ({ desc = Primitive ({ name = "delay"; _ }, _); _ }, _); _ }; _ }
    ->
      Printf.sprintf "the initial value of `delay` must be static, but %s" what
  | Head { head = { desc = Apply _; _ } as h; _ } when not (runs_a_local h) ->
      Printf.sprintf "the arguments of %s before its signal must be static, but %s"
        (Misplaced_instance.name h) what
  | Head _ -> Printf.sprintf "the signal function that runs here must be static, but %s" what
  | Binding_of x ->
      Printf.sprintf "`%s` is a signal function and must be static, but %s" x.name what
  | Binding_of_task x -> Printf.sprintf "`%s` is a task and must be static, but %s" x.name what

(* The hint for a signal function with an argument that is not static. *)
let for_arguments sources ~value head input =
  match Settings.hint sources ~value ~head ~input with
  | Some hint -> hint
  | None when runs_a_local head ->
      "static values must be known when the signal function starts: pass a signal in its input, or \
       use `initially` to start it with the first value of a signal"
  | None ->
      "a static value must be known when the signal function starts: run one signal function for \
       each of a few constant settings and choose between their outputs, pass the signal in the \
       input, or use `initially` to keep its first value"

(* `delay x 0`, with the arguments in the wrong order *)
let exchanged_delay sources (start : expr) (input : expr) =
  let quote e = Option.map Source.grouped (Settings.quote sources e) in
  match (quote start, quote input) with
  | Some x, Some constant when Settings.is_constant input ->
      let text = Printf.sprintf "delay %s %s" constant x in
      Some
        (fun d ->
          Diagnostic.hint "the initial value comes before the signal: write `%s`" text d
          |> Diagnostic.fix
               (Printf.sprintf "write `%s`" text)
               [ (start.span, constant); (input.span, x) ])
  | _ -> None

(* A hint that guesses what the programmer meant. *)
let likely sources (region : Level_fact.region) =
  match region with
  | Head
      {
        head = { desc = Apply ({ desc = Primitive ({ name = "delay"; _ }, _); _ }, start); _ };
        input;
        _;
      }
    when exchanged_delay sources start input <> None ->
      Option.get (exchanged_delay sources start input)
  | Head { head = { desc = Apply ({ desc = Primitive ({ name = "delay"; _ }, _); _ }, _); _ }; _ }
    ->
      Diagnostic.hint
        "write a constant, as in `delay 0 x`; to start with the first value of `x` instead, write \
         `previous x`, with `import Control`"
  | Head { head = { desc = If _ | Case _; _ }; _ } ->
      Diagnostic.hint
        "run each signal function in a separate equation, and choose between their outputs"
  | Head
      {
        head =
          { desc = Apply ({ desc = Apply ({ desc = Primitive ({ name; _ }, _); _ }, _); _ }, _); _ };
        _;
      }
    when name = "switch" || name = "dSwitch" ->
      Diagnostic.hint "pass the value in the event of the `%s`, or use `initially`" name
  | Binding_of_task _ ->
      Diagnostic.hint
        "pass values that are known at the start as parameters of the task, and signals in its \
         input"
  | Head { head; input; value } -> Diagnostic.hint "%s" (for_arguments sources ~value head input)
  | Binding_of x ->
      Diagnostic.hint
        "pass signals in its input: `%s` can take a pair, as in `proc (x, y) -> …`; to pass a \
         value from one mode to the next, use the event of the switch"
        x.name

let code : Level_fact.region -> string = function
  | Head _ -> "E0340"
  | Binding_of _ | Binding_of_task _ -> "E0344"

let reason d ({ variable; why } : Level_fact.reason) =
  let label at text = Diagnostic.label ~at "`%s` is a signal: %s" variable.name text d in
  match why with
  | Input -> label variable.span "it comes from the `proc`'s input here"
  | Runs_at at -> label at "a signal function runs here"
  | Depends_on (other, at) -> label at (Printf.sprintf "it depends on `%s` here" other.name)

let not_static sources ~at region (cause : Level_fact.cause) =
  let what, reasons =
    match cause with
    | Mentions (x, reasons) -> (Printf.sprintf "`%s` is a signal" x.name, reasons)
    | Runs head -> (Printf.sprintf "%s runs here" (Misplaced_instance.name head), [])
  in
  let error = Diagnostic.error ~code:(code region) ~at "%s" (complaint region what) in
  List.fold_left reason error reasons |> likely sources region

let recursive (x : Local.t) (use : expr) =
  let why =
    match use.ty with
    | Function _ -> "a function cannot call itself"
    | Signal_function _ | Variable _ | Number _ | Bool | String | Tuple _ | Data _ | Size _ ->
        "only the equations of a `proc` may be recursive"
  in
  Diagnostic.(
    error ~code:"E0346" ~at:use.span "`%s` is used in its own definition" x.name
    |> here "%s" why
    |> label ~at:x.span "`%s` is defined here" x.name)

let diagnostic sources (fact : Level_fact.t) =
  match fact with
  | Not_static { at; region; cause } -> not_static sources ~at region cause
  | Misplaced { definition; within; position; obstacle; instance; head; input } ->
      Misplaced_instance.diagnostic sources ~definition ~within position obstacle instance ~head
        ~input
  | Recursive { variable; use } -> recursive variable use
  | Index_not_constant { index; array; problem } ->
      Index_mistake.not_constant sources ?array index problem
  | Index_outside { array; index; value; size } ->
      Index_mistake.outside sources ~array ~index value ~size
