open Basis

type advice = Renamed of string | Other of string

let marker = "Deprecated:"

(* The text after the marker, up to the end of the comment. *)
let after_marker doc =
  let n = String.length marker in
  let rec from k =
    if k + n > String.length doc then None
    else if String.sub doc k n = marker then
      Some (String.trim (String.sub doc (k + n) (String.length doc - k - n)))
    else from (k + 1)
  in
  from 0

let advice doc =
  let read text =
    match String.split_on_char '`' text with
    | [ "renamed to "; name; rest ] when String.length rest <= 1 -> Renamed name
    | _ ->
        let text = String.concat " " (List.map String.trim (String.split_on_char '\n' text)) in
        let n = String.length text in
        Other (if String.ends_with ~suffix:"." text then String.sub text 0 (n - 1) else text)
  in
  Option.map read (Option.bind doc after_marker)

let deprecated (p : Ir.program) =
  let add table name doc = Option.iter (Hashtbl.replace table name) (advice doc) in
  let table = Hashtbl.create 16 in
  List.iter (fun (x : Ir.primitive) -> add table x.name x.doc) p.primitives;
  List.iter
    (fun (g : Ir.binding_group) ->
      List.iter
        (fun (b : Ir.binding) ->
          match b.name with Top (name, _) -> add table name b.doc | Inner _ | Destructure _ -> ())
        g.bindings)
    p.groups;
  table

(* A qualified name is longer, and the new name might need another qualifier. *)
let is_plain (name : Ir.Global.t) (span : Span.t) =
  Span.line span.start = Span.line span.stop
  && Span.column span.stop - Span.column span.start = String.length name.name

(* Can the module that contains the place use all names of the other module without a qualifier? *)
let sees_all_of (p : Ir.program) (span : Span.t) module_ =
  module_ = "Prelude"
  || List.exists
       (fun (m : Ir.module_) ->
         m.file = span.file && (m.name = module_ || List.mem module_ m.imported))
       p.modules

let report sink p (name : Ir.Global.t) span advice =
  let write fresh = Printf.sprintf "write `%s`, its new name" fresh in
  Diagnostic.warning ~code:"W0317" ~at:span "`%s` is deprecated" name.name
  |> (match advice with
     | Other text -> Diagnostic.hint text
     | Renamed fresh when not (is_plain name span) -> Diagnostic.hint (write fresh)
     | Renamed fresh when sees_all_of p span name.module_ ->
         fun d ->
           Diagnostic.hint (write fresh) d
           |> Diagnostic.fix ~safe:true (Printf.sprintf "write `%s`" fresh) [ (span, fresh) ]
     | Renamed fresh -> Diagnostic.hint (write fresh ^ ", and import it"))
  |> Diagnostic.emit sink

let warn sink (p : Ir.program) =
  let table = deprecated p in
  let rec expr (e : Ir.expr) =
    match e.desc with
    | Global name -> Option.iter (report sink p name e.span) (Hashtbl.find_opt table name)
    | _ -> Walk.expr visitor e
  and binding (b : Ir.binding) =
    match b.name with
    | Top (name, _) when Hashtbl.mem table name -> ()
    | Top _ | Inner _ | Destructure _ -> Walk.binding visitor b
  and visitor = { Walk.expr; pattern = ignore; binding } in
  if Hashtbl.length table > 0 then List.iter binding (Walk.own p)
