open Basis

let marker = "Deprecated:"

(* The text from the marker to the end of the comment. *)
let after_marker doc =
  let n = String.length marker in
  let rec from k =
    if k + n > String.length doc then None
    else if String.sub doc k n = marker then
      Some (String.trim (String.sub doc (k + n) (String.length doc - k - n)))
    else from (k + 1)
  in
  from 0

let deprecated (p : Ir.program) =
  let add table name doc =
    Option.iter (Hashtbl.replace table name) (Option.bind doc after_marker)
  in
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

(* Can the module that contains [span] use all names of [module_] without a qualifier? *)
let sees_all_of (p : Ir.program) (span : Span.t) module_ =
  module_ = "Prelude"
  || List.exists
       (fun (m : Ir.module_) ->
         m.file = span.file && (m.name = module_ || List.mem module_ m.imported))
       p.modules

let report facts p (name : Ir.Global.t) (at : Span.t) text =
  let is_visible = sees_all_of p at name.module_ in
  Facts.report facts (Fact.Warning (Deprecated { name; at; text; is_visible }))

let warn facts (p : Ir.program) =
  let table = deprecated p in
  let rec expr (e : Ir.expr) =
    match e.desc with
    | Global name -> Option.iter (report facts p name e.span) (Hashtbl.find_opt table name)
    | _ -> Walk.expr visitor e
  and binding (b : Ir.binding) =
    match b.name with
    | Top (name, _) when Hashtbl.mem table name -> ()
    | Top _ | Inner _ | Destructure _ -> Walk.binding visitor b
  and visitor = { Walk.expr; pattern = ignore; binding } in
  if Hashtbl.length table > 0 then List.iter binding (Walk.own p)
