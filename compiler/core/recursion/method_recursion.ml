open Basis
module Global_table = Resolve.Global_table

type definition = { core : Ir.definition; uses : Uses.use list }

(* The definitions that can reach a method at a type variable. *)
let that_use_methods { Uses.definitions; index; uses } =
  let uses = Array.map (List.filter (fun (use : Uses.use) -> not use.later)) uses in
  let users = Array.make (Array.length definitions) [] in
  let note i (use : Uses.use) =
    match use.target with
    | Definition (g, _) ->
        Option.iter (fun j -> users.(j) <- i :: users.(j)) (Global_table.find_opt index g)
    | Method _ -> ()
  in
  Array.iteri (fun i uses -> List.iter (note i) uses) uses;
  let found = Global_table.create 64 in
  let rec spread = function
    | [] -> ()
    | i :: rest when Global_table.mem found definitions.(i).name -> spread rest
    | i :: rest ->
        Global_table.replace found definitions.(i).name { core = definitions.(i); uses = uses.(i) };
        spread (List.rev_append users.(i) rest)
  in
  let is_method (use : Uses.use) =
    match use.target with Method _ -> true | Definition _ -> false
  in
  Array.iteri (fun i uses -> if List.exists is_method uses then spread [ i ]) uses;
  found

(* {1 Instantiated definitions} *)

module Instantiations = Hashtbl.Make (struct
  type t = Ir.Global.t * Ir.ty list

  let equal = ( = )
  let hash key = Hashtbl.hash_param 100 200 key
end)

type vertex = {
  definition : definition;
  types : Ir.ty list;
  mutable out : (int * Span.t * bool) list;
      (** successors, each with its number, the place of the use, and whether the use goes through a
          method *)
}

type graph = {
  program : definition Global_table.t;
  instances : Instance.table;
  mutable facts : Fact.t list; (* newest first *)
  numbers : int Instantiations.t;
  mutable vertices : vertex list; (* newest first *)
  mutable work : vertex list;
}

(* Only types that grow from call to call exceed this depth or size. *)
let deepest_type = 100
let most_parts = 20_000

exception Large

(* Parts of a type may be shared in memory, so a traversal may visit the same part many times. *)
let is_large ty =
  let parts = ref 0 in
  let rec visit depth (ty : Ir.ty) =
    incr parts;
    Work.step ();
    if depth > deepest_type || !parts > most_parts then raise_notrace Large;
    match ty with
    | Variable _ | Bool | Int | Float | String | Size _ -> ()
    | Tuple tys | Data (_, tys) -> List.iter (visit (depth + 1)) tys
    | Function (a, b) | Signal_function (a, b) | Array (a, b) ->
        visit (depth + 1) a;
        visit (depth + 1) b
  in
  match visit 1 ty with () -> false | exception Large -> true

let report g fact = g.facts <- fact :: g.facts

(* Maximum number of steps for building the graph; each step visits a part of a type. *)
let most_steps = 5_000_000

(* The number of the instantiated definition; [None] if it cannot reach a method, or if one of the
   types is too large. *)
let vertex g name types ~span =
  match Global_table.find_opt g.program name with
  | None -> None
  | Some definition -> (
      match Instantiations.find_opt g.numbers (name, types) with
      | Some number -> Some number
      | None when List.exists is_large types ->
          report g (Growing_types { definition = definition.core; at = span });
          None
      | None ->
          let number = Instantiations.length g.numbers in
          let v = { definition; types; out = [] } in
          Instantiations.replace g.numbers (name, types) number;
          g.vertices <- v :: g.vertices;
          g.work <- v :: g.work;
          Some number)

let follow g v =
  let close = Erasure.substitute (List.combine v.definition.core.parameters v.types) in
  let closed = List.map close in
  let use ({ target; span; later = _ } : Uses.use) =
    let to_ (name, types) ~by_method =
      match vertex g name types ~span with
      | Some number -> v.out <- (number, span, by_method) :: v.out
      | None -> ()
    in
    match target with
    | Definition (name, types) -> to_ (name, closed types) ~by_method:false
    | Method { class_; name; ty; types } ->
        Option.iter (to_ ~by_method:true)
          (Instance.find g.instances ~class_ ~name (close ty) (closed types))
  in
  List.iter use v.definition.uses

let rec follow_all g =
  match g.work with
  | [] -> ()
  | v :: rest ->
      g.work <- rest;
      follow g v;
      follow_all g

(* Starts from the closed definitions and from each instance's methods, with the instance's own type
   variables as type arguments. *)
let start g (program : Ir.program) =
  let own (d : definition) = List.map (fun v -> Ir.Variable v) d.core.parameters in
  let enter name types =
    match Global_table.find_opt g.program name with
    | Some d -> ignore (vertex g name (types (own d)) ~span:d.core.span)
    | None -> ()
  in
  List.iter
    (fun (d : Ir.definition) -> if d.parameters = [] then enter d.name Fun.id)
    program.definitions;
  let method_ (i : Ir.instance) (_, (implementation : Ir.implementation)) =
    match implementation with
    | Given name -> enter name Fun.id
    | Default name -> enter name (function [] -> [] | _ :: others -> i.head :: others)
  in
  List.iter (fun (i : Ir.instance) -> List.iter (method_ i) i.methods) program.instances

(* {1 Cycles} *)

(* Maps each default definition, which has the name of its method, to its class. *)
let defaults (program : Ir.program) =
  let table = Hashtbl.create 16 in
  let method_ (i : Ir.instance) (_, (implementation : Ir.implementation)) =
    match implementation with Default name -> Hashtbl.replace table name i.class_ | Given _ -> ()
  in
  List.iter (fun (i : Ir.instance) -> List.iter (method_ i) i.methods) program.instances;
  table

let cycle defaults vertices numbers : Fact.t =
  let use a b =
    List.find_opt (fun (target, _, _) -> target = b) vertices.(a).out
    |> Option.map (fun (_, span, _) -> span)
  in
  let default v =
    match (Hashtbl.find_opt defaults vertices.(v).definition.core.name, vertices.(v).types) with
    | Some class_, ty :: _ -> Some (class_, ty)
    | Some _, [] | None, _ -> None
  in
  let definitions = Array.map (fun v -> v.definition.core) vertices in
  Cycle
    {
      cycle = Uses.cycle definitions ~use numbers;
      cause = Methods { default = List.find_map default numbers };
    }

let closed_by_a_method vertices component =
  List.exists
    (fun v ->
      List.exists
        (fun (target, _, by_method) -> by_method && List.mem target component)
        vertices.(v).out)
    component

let of_instances (program : Ir.program) uses =
  let g =
    {
      program = that_use_methods uses;
      instances = Instance.table program.instances;
      facts = [];
      numbers = Instantiations.create 64;
      vertices = [];
      work = [];
    }
  in
  start g program;
  (match Work.within most_steps (fun () -> follow_all g) with
  | Some () -> ()
  | None ->
      let combinations = Instantiations.length g.numbers in
      let many v = report g (Too_many_types { definition = v.definition.core; combinations }) in
      Option.iter many (List.nth_opt g.vertices 0));
  let vertices = Array.of_list (List.rev g.vertices) in
  Array.iter (fun v -> v.out <- List.rev v.out) vertices;
  let graph = Array.map (fun v -> List.map (fun (target, _, _) -> target) v.out) vertices in
  let defaults = defaults program in
  List.iter
    (fun component ->
      if Graph.is_cyclic graph component && closed_by_a_method vertices component then
        report g (cycle defaults vertices (Graph.shortest_cycle graph component)))
    (Graph.components graph);
  List.rev g.facts

let facts (program : Ir.program) uses =
  if program.instances = [] then [] else of_instances program uses
