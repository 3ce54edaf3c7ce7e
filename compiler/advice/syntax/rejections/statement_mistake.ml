open Basis
open Syntax

let error at format = Diagnostic.error ~code:"E0116" ~at format

(* {1 The statements of a [proc]} *)

(* The first word of an expression, if it is a name. *)
let rec first_word (e : Ir.expr) =
  match e.desc with
  | Variable { qualifier = None; name; _ } -> Some name
  | Apply (head, _) -> first_word head
  | Binary { left; _ } -> first_word left
  | _ -> None

(* A loop in the notation of another language. *)
let loop (word : Ir.name) =
  match word.text with
  | "while" | "for" | "foreach" | "repeat" ->
      Some
        (error word.span "a `proc` has no loops, so it cannot contain `%s`" word.text
        |> Diagnostic.hint
             "all statements of a `proc` hold at every instant: choose a value with `if c then a \
              else b`, or repeat a task with `whileT c t`")
  | _ -> None

let waiting (word : Ir.name) =
  if Beginnings.waits word.text then
    Some
      (error word.span "a `proc` cannot wait: all its statements hold at every instant"
      |> Diagnostic.suggest Beginnings.waiting)
  else None

let in_proc ~is_last (e : Ir.expr) =
  let of_word rule = Option.bind (first_word e) rule in
  match List.find_map of_word [ loop; waiting ] with
  | Some diagnostic -> diagnostic
  | None when is_last ->
      error e.span "the last statement of this `do` is its output, so it needs `-<`"
      |> Diagnostic.hint "write `returnA -< …` to output this value"
  | None ->
      error e.span "this expression cannot be a statement of a `proc`"
      |> Diagnostic.hint
           "a `proc` has no side effects: bind the value with `let x = e`, or run a signal \
            function with `x <- sf -< e`; for tasks, use a `do` without `proc`"

let end_with_output name =
  Diagnostic.hint "end the `do` with its output, as in `returnA -< %s`"
    (Option.value name ~default:"x")

let output_binds ~at name =
  error at "the last statement of this `do` is its output, so it cannot bind a name"
  |> end_with_output name

let output_is_let ~at name =
  error at "the last statement of this `do` is a `let`, so it has no output" |> end_with_output name

let empty_proc at = error at "this `do` is empty, so it has no output" |> end_with_output None

(* {1 Tasks} *)

let end_with_task = Diagnostic.hint "end the `do` with a task, as in `return x`"
let last_is at what = error at "the last statement of a `do` must be a task, so it cannot %s" what

let last_task_binds ~at name =
  last_is at "bind a name"
  |>
  match name with
  | Some name ->
      Diagnostic.hint
        "remove `%s <-` to return the task's result, or add a last statement such as `return %s`"
        name name
  | None -> end_with_task

let last_task_is_let at = last_is at "be a `let`" |> end_with_task
let empty_task at = error at "this `do` is empty: it contains no task" |> end_with_task

let rec_in_task at =
  error at "`rec` is only allowed in the `do` of a `proc`, because tasks run one after the other"
  |> Diagnostic.hint
       "to repeat a task, write `forever t`, or call the task itself in its last statement"
