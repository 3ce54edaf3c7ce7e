open Basis
open Basis.Let_syntax.Option

let lint flow =
  Flow.Lint.program flow;
  Flow.Initialization.check flow

(* Specializes the program, and checks the rules that every program must follow. These checks
   precede the passes that move equations, so that messages refer to equations as they were
   written. *)
let with_room ~options ~default ~name ~entry sink ~sources ~(written : Typing.Ir.definition) core
    marks =
  let options = { options with Specialize.Context.marks } and span = written.span in
  let* flow =
    Specialize.Of_core.program ~options ~default (Advice.Of_specialize.into sink) ~name ~entry core
  in
  let facts = Advice.Of_flow.into ~sources sink in
  Flow.Extent.check facts ~entry:span flow;
  Flow.Causality.check facts ~entry:span flow;
  if Diagnostic.has_errors sink then None
  else Some (Flow.Instantaneous_loops.program facts ~entry:span flow)

(* A program that draws is specialized again with room for its marks, once their number is known. *)
let with_marks r sink ~written ~specialized (plain : Flow.Ir.program) =
  if plain.marks = 0 then Some plain
  else
    let* counted = specialized (Some 1) in
    let* marks = Drawing.bound sink written counted in
    if not (Drawing.is_shown r) then Some { plain with marks }
    else match marks with 0 -> Some plain | 1 -> Some counted | _ -> specialized (Some marks)

let program r sink sources ~options ~default ~name ~entry ~written core =
  let specialized = with_room ~options ~default ~name ~entry sink ~sources ~written core in
  let* flow = specialized None in
  with_marks r sink ~written ~specialized flow
