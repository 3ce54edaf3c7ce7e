open Basis
open Ir

(* A function or proc that encloses the current place. [owner]: the innermost definition in this
   frame that contains the place. *)
type frame = {
  depth : int;
  proc_depth : int;  (** depth of the innermost proc that encloses this frame or is this frame *)
  mutable owner : Level_graph.node option;
}

type walk = {
  facts : Fact.t Facts.t;
  graph : Level_graph.t;
  unfinished : unit Int_table.t;
      (** variables of [let]s whose definitions have not been traversed completely *)
}

let origin (b : binding) : Level_graph.origin =
  match (b.pattern.desc, b.pattern.ty) with
  | Bound _, Signal_function _ -> Bound_signal_function
  | Bound _, Data { tycon; _ } when tycon = Environment.task -> Bound_signal_function
  | _ -> Derived

let name w node p = List.iter (fun x -> Level_graph.name w.graph x node) (Parts.variables p)

(* Types that allow recursion. Their values start later, so a definition of such a type may mention
   itself. *)
let rec starts = function
  | Signal_function _ -> true
  | Data { tycon; _ } -> tycon = Environment.task
  | Function (_, result) -> starts result
  | Tuple parts -> List.exists starts parts
  | Variable _ | Number _ | Bool | String | Size _ -> false

let mention w frames (x : Local.t) (e : expr) =
  if Int_table.mem w.unfinished x.id && not (starts e.ty) then
    Facts.report w.facts (Level (Recursive { variable = x; use = e }));
  match Level_graph.find w.graph x with
  | None -> Diagnostic.bug ~stage:"Typing.Levels" "`%s` has no level" x.name
  | Some node ->
      let bound_at = Level_graph.depth node in
      let rec visit = function
        | frame :: outer when frame.depth >= bound_at ->
            (match frame.owner with
            | Some within ->
                Level_graph.mention x ~at:e.span node ~within
                  ~inside_proc:(frame.proc_depth > bound_at)
            | None -> ());
            visit outer
        | _ -> ()
      in
      visit frames

let push frames ~proc =
  let depth, around = match frames with f :: _ -> (f.depth + 1, f.proc_depth) | [] -> (1, 0) in
  { depth; proc_depth = (if proc then depth else around); owner = None } :: frames

let innermost = function
  | frame :: _ -> frame
  | [] -> Diagnostic.bug ~stage:"Typing.Levels" "a traversal outside all frames"

(* An instance in a function may belong to the proc that encloses the function. *)
let runs w frames (e : expr) =
  let proc_depth = (innermost frames).proc_depth in
  List.iter
    (fun frame ->
      if frame.depth >= proc_depth then
        Option.iter (Level_graph.runs w.graph ~at:e.span) frame.owner)
    frames

let rec expr w frames (e : expr) =
  match e.desc with
  | Local (x, _) -> mention w frames x e
  | Run _ ->
      runs w frames e;
      Walk.parts (expr w frames) e
  | Case (scrutinee, branches) ->
      let node = part_node w frames Level_graph.Derived in
      part w frames node scrutinee;
      List.iter
        (fun (b : branch) ->
          name w node b.pattern;
          expr w frames b.value)
        branches
  | Let (bindings, body) ->
      let declare (b : binding) =
        let node = part_node w frames (origin b) in
        name w node b.pattern;
        List.iter
          (fun (x : Local.t) -> Int_table.replace w.unfinished x.id ())
          (Parts.variables b.pattern);
        (node, b)
      in
      let define (node, (b : binding)) =
        part w frames node b.value;
        List.iter
          (fun (x : Local.t) -> Int_table.remove w.unfinished x.id)
          (Parts.variables b.pattern)
      in
      List.iter define (Long_list.map declare bindings);
      expr w frames body
  | Lambda (patterns, body) ->
      let frames = push frames ~proc:false in
      let depth = (innermost frames).depth in
      List.iter (name w (Level_graph.node w.graph ~depth Parameter)) patterns;
      expr w frames body
  | Proc { input; equations; output } -> proc w (push frames ~proc:true) input equations output
  | _ -> Walk.parts (expr w frames) e

(* A new node for a part of a definition that binds its own variables. *)
and part_node w frames origin =
  let frame = innermost frames in
  let node = Level_graph.node w.graph ~depth:frame.depth origin in
  Option.iter (fun within -> Level_graph.contain node ~within) frame.owner;
  node

and part w frames node e =
  let frame = innermost frames in
  let around = frame.owner in
  defined_by w frames node e;
  frame.owner <- around

and defined_by w frames node e =
  (innermost frames).owner <- Some node;
  expr w frames e

and proc w frames input equations output =
  let frame = innermost frames in
  let node origin = Level_graph.node w.graph ~depth:frame.depth origin in
  name w (node Input) input;
  let nodes =
    List.rev_map
      (fun (b : binding) ->
        let node = node (origin b) in
        name w node b.pattern;
        (node, b.value))
      equations
  in
  List.iter (fun (node, value) -> defined_by w frames node value) (List.rev nodes);
  frame.owner <- None;
  expr w frames output

let definition facts (d : definition) =
  let w = { facts; graph = Level_graph.create (); unfinished = Int_table.create 16 } in
  expr w (push [] ~proc:false) d.value;
  w.graph
