open Basis

type t = {
  analysis : Analysis.t;
  program : Resolve.Ir.program;
  tree : Syntax.Ir.program;
  facts : Place_types.t option Lazy.t;
  index : Index.t Lazy.t;
}

let of_analysis cache (a : Analysis.t) =
  match (a.resolved, a.tree) with
  | Some program, Some tree ->
      let facts = lazy (Option.map (Place_types.of_program ~main:program.main_module) a.typed) in
      let index = lazy (Index.of_analysis cache a ~typed:a.typed tree) in
      Some { analysis = a; program; tree; facts; index }
  | _ -> None

let analysis t = t.analysis
let tree t = t.tree
let index t = Lazy.force t.index
let facts t = Lazy.force t.facts
let program t = t.program

let prepare t =
  ignore (Lazy.force t.index);
  ignore (Lazy.force t.facts)

type seen = { view : t; now : Text.t; shift : Shift.t; back : Shift.t }

let seen view now shift = { view; now; shift; back = Shift.back shift }

(* Spans count lines by [\n] and columns in bytes, unlike editors. *)
let position s offset =
  Option.map
    (fun offset ->
      let text = Text.contents s.view.analysis.text in
      let rec count i line start =
        if i >= offset then (line, start)
        else
          count (i + 1)
            (if text.[i] = '\n' then line + 1 else line)
            (if text.[i] = '\n' then i + 1 else start)
      in
      let line, start = count 0 1 0 in
      Span.position ~line ~column:(offset - start + 1))
    (Shift.offset s.back offset)

let offset (a : Analysis.t) position =
  let sources = a.sources in
  match Source.text sources a.shown with
  | Some _ -> Source.offset sources a.shown position
  | None -> 0

let shifted shift s (span : Span.t) =
  let a = s.view.analysis in
  if String.equal span.file a.shown then shift s.shift (offset a span.start, offset a span.stop)
  else None

(* [None] if the word is now part of a longer one. *)
let place s span =
  let text = Text.contents s.now in
  let is_name_at i = i >= 0 && i < String.length text && Basis.Character.is_name text.[i] in
  match shifted Shift.place s span with
  | Some (start, stop) when is_name_at start && (is_name_at (start - 1) || is_name_at stop) -> None
  | found -> found

let place_at s offset span =
  match place s span with
  | Some (start, stop) when start <= offset && offset <= stop -> Some (start, stop)
  | Some _ | None -> None

let range = shifted Shift.range
