open Basis

let prelude name (e : Resolve.Ir.expr) =
  match e.desc with
  | Global g -> String.equal g.module_ "Prelude" && String.equal g.name name
  | _ -> false

let is_return (e : Resolve.Ir.expr) =
  match e.desc with Apply { head; style = Juxtaposed; _ } -> prelude "return" head | _ -> false

(* Does the task only return a value, in every case? *)
let rec only_returns (e : Resolve.Ir.expr) =
  is_return e
  ||
  match e.desc with
  | If { then_; else_; _ } -> only_returns then_ && only_returns else_
  | Apply
      { head = { desc = Apply { head; style = Juxtaposed; _ }; _ }; argument; style = Juxtaposed }
    ->
      prelude "whenT" head && only_returns argument
  | _ -> false

(* Removes the line. The next statement is on the next line, so there is nothing in between. *)
let without (e : Resolve.Ir.expr) next d =
  match (next : Span.t option) with
  | Some next when Span.line next.start = Span.line e.span.stop + 1 ->
      Diagnostic.fix ~safe:true "remove it"
        [ (Span.make ~file:e.span.file ~start:e.span.start ~stop:next.start, "") ]
        d
  | Some _ | None -> d

let warn (ctx : Context.t) (e : Resolve.Ir.expr) ~next =
  let tell message = Diagnostic.warning ~code:"W0312" ~at:e.span message in
  if is_return e then
    tell "this `return` has no effect: the statements after it still run"
    |> Diagnostic.hint "remove it: a task ends after its last statement"
    |> without e next |> Diagnostic.emit ctx.reader.sink
  else if only_returns e then
    tell "this does not end the task: the statements after it still run"
    |> Diagnostic.hint
         "move the remaining statements into the other branch: `if c then return x else do`"
    |> Diagnostic.emit ctx.reader.sink
