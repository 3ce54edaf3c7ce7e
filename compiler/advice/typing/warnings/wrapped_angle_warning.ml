open Basis
open Typing.Ir

let is_atom (e : expr) =
  match e.desc with
  | Local _ | Global _ | Field _ | Number _ | Tuple _ | Array _ -> true
  | _ -> false

let after (e : expr) = Span.make ~file:e.span.file ~start:e.span.stop ~stop:e.span.stop
let before (e : expr) = Span.make ~file:e.span.file ~start:e.span.start ~stop:e.span.start

(* Adds the import of a library module to a fix at this place, unless the module is already
   imported. *)
let with_import (resolved : Resolve.Ir.program) (at : Span.t) library_module edits =
  let is_here (m : Resolve.Ir.module_) = String.equal m.file at.file in
  match List.find_opt is_here resolved.modules with
  | Some m when not (List.mem library_module m.imported) ->
      let { Resolve.Ir.place; before; after } = m.import_place in
      (place, before ^ "import " ^ library_module ^ after) :: edits
  | Some _ | None -> edits

let difference sources resolved (e : expr) (a : expr) (b : expr) =
  let opening e = if is_atom e then "" else "(" and closing e = if is_atom e then "" else ")" in
  let quote (e : expr) =
    Option.map (fun text -> opening e ^ text ^ closing e) (Source.quote sources e.span)
  in
  let written =
    match (quote a, quote b) with
    | Some a, Some b when String.length a + String.length b < 70 ->
        Printf.sprintf "write `angleDiff %s %s` (module Geometry)" a b
    | _ -> "write `angleDiff a b` (module Geometry) instead of `a - b`"
  in
  let between = Span.make ~file:e.span.file ~start:a.span.stop ~stop:b.span.start in
  Diagnostic.(
    warning ~code:"W0315" ~at:e.span
      "this difference between two angles can be more than half a turn"
    |> note
         "from -179 degrees to 179 degrees, the difference is 358 degrees; the shortest rotation \
          is -2 degrees"
    |> hint "%s" written
    |> fix "use `angleDiff`"
         (with_import resolved e.span "Geometry"
            [
              (before e, "angleDiff " ^ opening a);
              (between, closing a ^ " " ^ opening b);
              (after e, closing b);
            ]))

let use_unwrap resolved (head : expr) edits =
  Diagnostic.fix "use `unwrap`" (with_import resolved head.span "Angles" edits)

let unwrapped resolved head (unwrap : Typing.Warning_fact.unwrap) =
  match unwrap with
  | Around None -> Fun.id
  | Around (Some angle) ->
      (* other arguments already have parentheses, outside their span *)
      let opening, closing = if is_atom angle then ("(unwrap ", ")") else ("unwrap (", ")") in
      use_unwrap resolved head [ (before angle, opening); (after angle, closing) ]
  | Before f -> use_unwrap resolved head [ (before f, "unwrap >>> ") ]

let of_module = Printf.sprintf "`%s` (module %s)"

(* The fix that makes the angle continuous is also correct for a multiple of an angle. *)
let wrapped resolved ~name ~(head : expr) ~(angle : expr) ~scaled ~instead ~module_ ~same_arguments
    unwrap =
  let d =
    Diagnostic.(
      warning ~code:"W0315" ~at:head.span "`%s` is applied to an angle that wraps" name
      |> label ~at:angle.span "this angle is between -pi and pi"
      |> note "when the angle jumps from pi to -pi, `%s` sees a rotation of 360 degrees" name)
  in
  if scaled || String.equal instead "unwrap" then
    Diagnostic.hint "%s" ("make the angle continuous with " ^ of_module "unwrap" "Angles") d
    |> unwrapped resolved head unwrap
  else
    Diagnostic.hint "%s"
      ((if same_arguments then "write " else "use ") ^ of_module instead module_)
      d
    |>
    if same_arguments then
      Diagnostic.fix
        (Printf.sprintf "write `%s`" instead)
        (with_import resolved head.span module_ [ (head.span, instead) ])
    else Fun.id
