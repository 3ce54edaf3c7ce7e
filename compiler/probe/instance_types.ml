open Basis
module Ir = Typing.Ir

type t = {
  written : Signal_types.t;
  flow : Flow.Ir.program;
  definitions : (string, Ir.definition) Hashtbl.t;
      (** definitions, by their name within the module *)
  uses : (Ir.Global.t, Span.t * Ir.ty) Hashtbl.t;
  all_uses : (string, Ir.Global.t * Span.t * Ir.ty) Hashtbl.t;  (** uses, by file *)
  known : (Catalogue.step list, Substitution.t) Hashtbl.t;
      (** the values of variables, by the path to an instance *)
}

let of_program (typed : Ir.program) flow =
  let definitions = Hashtbl.create 256 in
  let uses = Hashtbl.create 1024 and all_uses = Hashtbl.create 16 in
  let rec expr (e : Ir.expr) =
    (match e.desc with
    | Global (name, _) ->
        Hashtbl.add uses name (e.span, e.ty);
        Hashtbl.add all_uses e.span.file (name, e.span, e.ty)
    | _ -> ());
    Typing.Walk.parts expr e
  in
  List.iter
    (fun (d : Ir.definition) ->
      Hashtbl.add definitions d.name.name d;
      expr d.value)
    typed.definitions;
  {
    written = Signal_types.of_program typed;
    flow;
    definitions;
    uses;
    all_uses;
    known = Hashtbl.create 64;
  }

let is_inside (inner : Span.t) (outer : Span.t) =
  String.equal inner.file outer.file && inner.start >= outer.start && inner.stop <= outer.stop

let definition_of t (node : Flow.Ir.node) =
  List.find_opt
    (fun (d : Ir.definition) -> is_inside node.span d.span)
    (Hashtbl.find_all t.definitions node.origin)

(* The types at which a place uses a definition: only the type of the first use if [only_head] is
   true, otherwise the types of all uses. *)
let types_at t (d : Ir.definition) ~only_head (place, around) =
  let uses = List.filter (fun (span, _) -> is_inside span place) (Hashtbl.find_all t.uses d.name) in
  let first = List.fold_left (fun first ((s : Span.t), _) -> min first s.start) place.stop uses in
  List.filter (fun ((s : Span.t), _) -> (not only_head) || s.start = first) uses
  |> List.map (fun (_, ty) -> Substitution.apply around ty)
  |> List.sort_uniq compare

(* Like {!types_at}, but searches the definitions that a place uses: for example, the definition
   [f = lowPass 1[s]] for a place that contains [f x]. *)
let rec types_behind t d ~depth (place, around) =
  let behind ((name : Ir.Global.t), span, ty) =
    if not (is_inside span place) then []
    else
      Hashtbl.find_all t.definitions name.name
      |> List.filter (fun (other : Ir.definition) -> other.name = name)
      |> List.concat_map (fun (other : Ir.definition) ->
             let ty = Substitution.apply around ty in
             let inside = (other.span, Substitution.matching other.scheme.ty ty) in
             match types_at t d ~only_head:false inside with
             | [] -> types_behind t d ~depth:(depth - 1) inside
             | found -> found)
  in
  if depth = 0 then []
  else
    List.concat_map behind (Hashtbl.find_all t.all_uses place.Span.file) |> List.sort_uniq compare

(* The values of the type variables inside a node. [places]: the places where the node and the
   instances around it run, innermost first, each with the values of the type variables there. If
   the node is an argument of a function, such as the first argument of [>>>], it is used at an
   outer place. If the uses of a node have different types, its variables have no values. *)
let entered t (node : Flow.Ir.node) ~only_head places =
  let around = match places with (_, values) :: _ -> values | [] -> Substitution.empty in
  let rec types d ~only_head = function
    | [] -> []
    | place :: outer -> (
        match types_at t d ~only_head place with
        | [] -> (
            match types_behind t d ~depth:3 place with
            | [] -> types d ~only_head:false outer
            | found -> found)
        | found -> found)
  in
  match definition_of t node with
  | None -> around
  | Some d -> (
      let others = Substitution.without (d.scheme.units @ d.scheme.types) around in
      match types d ~only_head places with
      | [ ty ] -> Substitution.union (Substitution.matching d.scheme.ty ty) others
      | _ -> others)

(* The values of the type variables in the node at the end of a path from the root. The root is the
   program's last node. *)
let at t path =
  let rec follow node places values = function
    | [] -> values
    | step :: rest ->
        let next, place, only_head =
          match (step : Catalogue.step) with
          | Instance k ->
              let i = List.nth t.flow.nodes.(node).instances k in
              (i.node, i.span, true)
          | Mode k -> (
              match t.flow.nodes.(node).machine with
              | Some m -> (List.nth m.modes k, m.span, false)
              | None -> invalid_arg "Instance_types.at: a mode of a node without a machine")
        in
        let places = (place, values) :: places in
        follow next places (entered t t.flow.nodes.(next) ~only_head places) rest
  in
  match Hashtbl.find_opt t.known path with
  | Some values -> values
  | None ->
      let values = follow (Array.length t.flow.nodes - 1) [] Substitution.empty path in
      Hashtbl.replace t.known path values;
      values

let type_of t (p : Catalogue.probe) =
  Option.map (Substitution.apply (at t p.path)) (Signal_types.type_of t.written p)
