open Basis

(* If the next statement starts on the next line, adds a fix that removes the statement. Otherwise,
   the fix would also remove the lines between them. *)
let without (e : Resolve.Ir.expr) next d =
  match (next : Span.t option) with
  | Some next when Span.line next.start = Span.line e.span.stop + 1 ->
      Diagnostic.fix ~safe:true "remove it"
        [ (Span.make ~file:e.span.file ~start:e.span.start ~stop:next.start, "") ]
        d
  | Some _ | None -> d

(* The beginning of a choice that ends the task in its first branch. *)
let ending_choice words (e : Resolve.Ir.expr) =
  match e.desc with
  | If { condition; then_; _ } when Typing.Plain_name.of_head then_ = Some "return" -> (
      match (Wording.quote words condition.span, Wording.quote words then_.span) with
      | Some condition, Some then_ -> Printf.sprintf "if %s then %s else do" condition then_
      | _ -> "if c then return x else do")
  | _ -> "if c then return x else do"

let idle_return words (e : Resolve.Ir.expr) ~is_choice ~next =
  let warning message = Diagnostic.warning ~code:"W0312" ~at:e.span message in
  if is_choice then
    warning "this does not end the task: the statements after it still run"
    |> Diagnostic.hint "move the remaining statements into the other branch: `%s`"
         (ending_choice words e)
  else
    warning "this `return` has no effect: the statements after it still run"
    |> Diagnostic.hint "remove it: a task ends after its last statement"
    |> without e next

let unreachable ~at (endless : Resolve.Ir.expr) =
  Diagnostic.warning ~code:"W0318" ~at "this statement is never reached"
  |> Diagnostic.label ~at:endless.span "this task never ends"
  |> Diagnostic.hint
       "remove the statements after the task, or end the task with ``t `timeOut` 30[s]`` or with \
        `abortWhen` and an event"
