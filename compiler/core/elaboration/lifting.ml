open Basis
module T = Typing.Ir
module Global_table = Resolve.Global_table

type use = {
  definition : Ir.Global.t;
  around : Ir.variable list;
  captured : Ir.binder list;
  pattern : T.pattern;
}

type table = { uses : use Int_table.t; names : unit Global_table.t }

let table () = { uses = Int_table.create 16; names = Global_table.create 16 }

module Renaming = Map.Make (Int)

type scope = { home : string; in_scope : Ir.variable list; renamed : Ir.Local.t Renaming.t }

let names p = List.rev (Typing.Parts.variables p)
let home (g : Ir.Global.t) = g.module_ ^ "." ^ g.name
let scope name in_scope = { home = home name; in_scope; renamed = Renaming.empty }
let renamed scope (x : Ir.Local.t) = Option.value (Renaming.find_opt x.id scope.renamed) ~default:x

let functions (parameters : Ir.binder list) result =
  List.fold_right (fun (b : Ir.binder) ty -> Ir.Function (b.ty, ty)) parameters result

let variable t scope (e : T.expr) (x : Ir.Local.t) types =
  let ty = Erasure.ty e.ty and span = e.span in
  match Int_table.find_opt t.uses x.id with
  | None -> Term.make ty span (Ir.Local (renamed scope x))
  | Some { definition; around; captured; pattern } ->
      let give (f : Ir.expr) (b : Ir.binder) =
        match f.ty with
        | Function (_, result) ->
            Term.apply f (Term.make b.ty span (Ir.Local (renamed scope b.local))) result span
        | _ -> Diagnostic.bug ~stage:"Core.Lifting" "`%s` has too few parameters" x.name
      in
      let whole = match pattern.desc with Bound _ -> ty | _ -> Erasure.ty pattern.ty in
      let types = List.map (fun v -> Ir.Variable v) around @ types in
      let global = Term.make (functions captured whole) span (Ir.Global (definition, types)) in
      Matching.part pattern ~root:(List.fold_left give global captured) x

type lifted = {
  binding : T.binding;
  inside : scope;
  name : Ir.Global.t;
  types : Ir.variable list;
  parameters : Ir.binder list;
}

let unique t scope name : Ir.Global.t =
  let rec from n : Ir.Global.t =
    let module_ = if n = 1 then scope.home else Printf.sprintf "%s.%d" scope.home n in
    let g : Ir.Global.t = { module_; name } in
    if Global_table.mem t.names g then from (n + 1) else g
  in
  let g = from 1 in
  Global_table.replace t.names g ();
  g

(* The captured variables. A mentioned variable that has been lifted is replaced by the variables
   that its own definition captures. *)
let captured t ~own mentions =
  let expand (b : Ir.binder) =
    match Int_table.find_opt t.uses b.local.id with
    | Some use -> use.captured
    | None -> if List.mem b.local.id own then [] else [ b ]
  in
  let add found (b : Ir.binder) =
    if List.exists (fun (c : Ir.binder) -> c.local.id = b.local.id) found then found else b :: found
  in
  let variables = List.concat_map (fun (m : Mentions.t) -> m.variables) mentions in
  List.rev (List.fold_left add [] (List.concat_map expand variables))

let lift t ctx scope group =
  let variables = List.concat_map (fun ((b : T.binding), _) -> names b.pattern) group in
  let own = List.map (fun (x : Ir.Local.t) -> x.id) variables in
  let captured = captured t ~own (List.map snd group) in
  let one ((binding : T.binding), _) =
    let names = names binding.pattern in
    let name = unique t scope (match names with x :: _ -> x.Ir.Local.name | [] -> "it") in
    let use = { definition = name; around = scope.in_scope; captured; pattern = binding.pattern } in
    List.iter (fun (x : Ir.Local.t) -> Int_table.replace t.uses x.id use) names;
    let parameter (b : Ir.binder) : Ir.binder =
      { b with local = Context.fresh ctx b.local.name b.local.span }
    in
    let parameters = List.map parameter captured in
    let rename renamed (b : Ir.binder) (p : Ir.binder) = Renaming.add b.local.id p.local renamed in
    let types = scope.in_scope @ Erasure.parameters binding.scheme in
    let inside =
      {
        home = home name;
        in_scope = types;
        renamed = List.fold_left2 rename scope.renamed captured parameters;
      }
    in
    { binding; inside; name; types; parameters }
  in
  List.map one group

let choose t ctx scope ~at_every_instant bindings =
  let is_polymorphic (b : T.binding) = Erasure.parameters b.scheme <> [] in
  let concerned (b : T.binding) =
    is_polymorphic b
    || (b.recursive && ((not at_every_instant) || Typing.Parts.is_static b.scheme.ty))
  in
  if not (List.exists concerned bindings) then ([], bindings)
  else
    let candidate (b : T.binding) =
      if not (concerned b) then None
      else
        let mentions = Mentions.of_expr b.value in
        if at_every_instant && mentions.runs then None else Some (b, mentions)
    in
    let candidates = Array.of_list (List.filter_map candidate bindings) in
    let owner = Int_table.create 16 in
    Array.iteri
      (fun i ((b : T.binding), _) ->
        List.iter (fun (x : Ir.Local.t) -> Int_table.replace owner x.id i) (names b.pattern))
      candidates;
    let edges (_, (m : Mentions.t)) =
      List.filter_map (fun (b : Ir.binder) -> Int_table.find_opt owner b.local.id) m.variables
    in
    let graph = Array.map edges candidates in
    let is_lifted group =
      Graph.is_cyclic graph group
      || List.exists (fun i -> is_polymorphic (fst candidates.(i))) group
    in
    let lifted =
      List.concat_map
        (fun group -> lift t ctx scope (List.map (fun i -> candidates.(i)) group))
        (List.filter is_lifted (Graph.components graph))
    in
    (lifted, List.filter (fun b -> List.for_all (fun l -> l.binding != b) lifted) bindings)

let definition { binding; inside = _; name; types; parameters } (value : Ir.expr) : Ir.definition =
  let span = match binding.pattern.desc with Bound x -> x.span | _ -> binding.span in
  let abstract (b : Ir.binder) (body : Ir.expr) =
    Term.make (Ir.Function (b.ty, body.ty)) span (Ir.Lambda (b, body))
  in
  let body = List.fold_right abstract parameters value in
  { name; parameters = types; ty = body.ty; body; span }
