open Basis

type t = {
  facts : Fact.t Facts.t;
  mutable has_errors : bool;
  mutable next_local : int;
  mutable depth : int;
  mutable too_deep : bool;  (** whether excessive nesting has been reported *)
  mutable unresolved : Fact.unresolved list;  (** undefined names of this module, newest first *)
}

let create facts =
  { facts; has_errors = false; next_local = 0; depth = 0; too_deep = false; unresolved = [] }

let report t (fact : Fact.t) =
  (match fact with Warning _ -> () | _ -> t.has_errors <- true);
  Facts.report t.facts fact

let report_definition t fact = report t (In_definitions fact)
let report_type t fact = report t (In_types fact)
let report_record t fact = report t (In_records fact)
let report_foreign t fact = report t (In_foreign_code fact)
let warn t fact = report t (Warning fact)
let report_unresolved t fact = t.unresolved <- fact :: t.unresolved

let tell t visible =
  (match List.rev t.unresolved with [] -> () | names -> report t (Unresolved { visible; names }));
  t.unresolved <- []

let parse t ~file text =
  let facts = Facts.map (fun fact -> Fact.Syntax fact) t.facts in
  let program = Syntax.Parse.program facts ~file text in
  if program = None then t.has_errors <- true;
  program

let has_errors t = t.has_errors

let fresh t name span : Ir.Local.t =
  let id = t.next_local in
  t.next_local <- id + 1;
  { id; name; span }

let deepest = 10_000

let nested t span ~otherwise f =
  if t.depth >= deepest then (
    if not t.too_deep then (
      t.too_deep <- true;
      report_definition t (Too_deep span));
    otherwise)
  else (
    t.depth <- t.depth + 1;
    let result = f () in
    t.depth <- t.depth - 1;
    result)

(* A new import goes on its own line, below any existing imports. *)
let import_place (program : Syntax.Ir.program) : Ir.import_place =
  let below (span : Span.t) = Span.make ~file:span.file ~start:span.stop ~stop:span.stop in
  match (List.rev program.imports, program.header) with
  | last :: _, _ -> { place = below last.span; before = "\n"; after = "" }
  | [], Some header -> { place = below header.span; before = "\n\n"; after = "" }
  | [], None -> { place = Span.start_of_file program.file; before = ""; after = "\n\n" }
