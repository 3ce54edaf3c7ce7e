open Basis
module Ir = Flow.Ir

type step = Instance of int | Mode of int
type own = Signal of Ir.signal | Running_mode

type probe = {
  name : string;
  path : step list;
  own : own;
  whole : string list;
  signal : string;
  ty : Ir.ty option;
  handed_down : bool;
  span : Span.t;
}

let most = 10_000
let longest = 1_000

(* {1 Names} *)

(* The name of a definition as users see it. For the method of an instance, this is the method's own
   name. *)
let plain name =
  match String.index_opt name '@' with
  | Some at when at > 0 -> String.sub name 0 at
  | Some _ | None -> name

(* Keeps the order; appends 1, 2, … to names that occur several times. *)
let numbered names =
  let total = String_table.create 8 and met = String_table.create 8 in
  let count table name = Option.value (String_table.find_opt table name) ~default:0 in
  let add table name = String_table.replace table name (count table name + 1) in
  List.iter (add total) names;
  List.map
    (fun name ->
      add met name;
      if count total name = 1 then name else Printf.sprintf "%s.%d" name (count met name))
    names

let mode_names (program : Ir.program) (machine : Ir.machine) =
  numbered (List.map (fun mode -> plain program.nodes.(mode).origin) machine.modes)

type inner = {
  step : step;
  word : string option;  (** the component that the step adds to the path, if any *)
  index : int;
  inputs : Ir.atom list;
}

let instances (program : Ir.program) (node : Ir.node) =
  let is_signal_function (_, (i : Ir.instance)) =
    let callee = program.nodes.(i.node) in
    callee.kind = Signal_function && Option.is_none callee.foreign
  in
  let by_place (_, (a : Ir.instance)) (_, (b : Ir.instance)) = Span.compare a.span b.span in
  let all =
    List.mapi (fun k i -> (k, i)) node.instances
    |> List.filter is_signal_function |> List.stable_sort by_place
  in
  let name (_, (i : Ir.instance)) =
    match program.nodes.(i.node) with
    | { machine = Some { modes = [ only ]; _ }; _ } -> plain program.nodes.(only).origin
    | callee -> plain callee.origin
  in
  let names = List.map name all in
  List.map2
    (fun (k, (i : Ir.instance)) name ->
      { step = Instance k; word = Some name; index = i.node; inputs = i.inputs })
    all (numbered names)

let modes (program : Ir.program) (node : Ir.node) (machine : Ir.machine) =
  let is_only = List.compare_length_with machine.modes 1 = 0 in
  let mode k index name =
    let word = if is_only || String.equal name (plain node.origin) then None else Some name in
    { step = Mode k; word; index; inputs = machine.inputs }
  in
  List.mapi
    (fun k (index, name) -> mode k index name)
    (List.combine machine.modes (mode_names program machine))

let inside program (node : Ir.node) =
  instances program node @ Option.fold ~none:[] ~some:(modes program node) node.machine

(* {1 The signals of a node} *)

let rec size (ty : Ir.ty) = match ty with Array (n, element) -> n * size element | _ -> 1
let rec scalar (ty : Ir.ty) = match ty with Array (_, element) -> scalar element | ty -> ty

let can_be_seen (program : Ir.program) (s : Ir.signal) =
  s.name <> ""
  (* The drawing as a whole is a separate signal. *)
  && (not (String.contains s.name '#'))
  && size s.ty <= longest
  && not (Flow.Shape.mentions_foreign program.sums (Leaf (scalar s.ty)))

let defined (node : Ir.node) =
  List.map (fun (e : Ir.equation) -> e.defines) node.equations
  @ List.concat_map (fun (i : Ir.instance) -> i.outputs) node.instances

(* Maps a signal to its origin if it is only a copy, made by an equation or by an instance that
   passes an input through. For each output of each earlier node, [passed] has the index of the
   input that it copies, if any. *)
let source passed (node : Ir.node) =
  let from = Hashtbl.create 16 in
  let comes (s : Ir.signal) (atom : Ir.atom) =
    match atom with Signal a -> Hashtbl.replace from s.id a.id | Bool _ | Int _ | Float _ -> ()
  in
  List.iter
    (fun (e : Ir.equation) -> match e.rhs with Copy atom -> comes e.defines atom | _ -> ())
    node.equations;
  let instance (i : Ir.instance) =
    let output s input = Option.iter (fun k -> comes s (List.nth i.inputs k)) input in
    if Option.is_none i.loop && passed.(i.node) <> [] then
      List.iter2 output i.outputs passed.(i.node)
  in
  List.iter instance node.instances;
  let rec source id = match Hashtbl.find_opt from id with Some id -> source id | None -> id in
  source

let passed_on (program : Ir.program) =
  let passed = Array.make (Array.length program.nodes) [] in
  let of_node k (node : Ir.node) =
    let source = source passed node in
    let number (_, (atom : Ir.atom)) =
      match atom with
      | Signal s ->
          let source = source s.id in
          let rec place k = function
            | [] -> None
            | (input : Ir.signal) :: _ when input.id = source -> Some k
            | _ :: rest -> place (k + 1) rest
          in
          place 0 node.inputs
      | Bool _ | Int _ | Float _ -> None
    in
    if Option.is_none node.foreign then passed.(k) <- List.map number node.outputs
  in
  Array.iteri of_node program.nodes;
  passed

let signals equations program (node : Ir.node) ~is_given ~source =
  let is_equation (s : Ir.signal) = Equations.mem equations s.span in
  let written =
    List.filter is_equation (defined node)
    |> List.stable_sort (fun (a : Ir.signal) (b : Ir.signal) -> Span.compare a.span b.span)
  in
  let met = String_table.create 16 in
  (* Binding an input to a tuple pattern creates two signals with the same name. *)
  let is_new (s : Ir.signal) =
    let before = Option.value (String_table.find_opt met s.name) ~default:[] in
    let source = source s.id in
    let is_new = not (List.mem source before) in
    if is_new then String_table.replace met s.name (source :: before);
    is_new
  in
  let seen (s : Ir.signal) = can_be_seen program s && is_new s in
  let all = List.filter seen (node.statics @ node.inputs @ written) in
  List.map2
    (fun (s : Ir.signal) name -> (Signal s, name, Some s.ty, is_given s.id, s.span))
    all
    (numbered (List.map (fun (s : Ir.signal) -> s.name) all))

(* The modes of a machine's node receive the same inputs, so the inputs of the node itself are
   skipped. *)
let own equations program (node : Ir.node) ~is_given ~source =
  match node.machine with
  | Some { modes = []; _ } | None -> signals equations program node ~is_given ~source
  | Some { modes = [ _ ]; _ } -> []
  | Some { modes = _ :: _ :: _; _ } -> [ (Running_mode, "mode", None, false, node.span) ]

(* {1 All signals} *)

(* For each node, counts the node itself and all the instances inside it. Returns whether the root's
   count exceeds {!most}. *)
let are_too_many (program : Ir.program) =
  let counts = Array.make (Array.length program.nodes) 1 in
  Array.iteri
    (fun k node ->
      List.iter
        (fun inner -> counts.(k) <- min (most + 1) (counts.(k) + counts.(inner.index)))
        (inside program node))
    program.nodes;
  counts.(Array.length counts - 1) > most

let rec found equations passed (program : Ir.program) index ~path ~whole ~given rest =
  let node = program.nodes.(index) in
  let source = source passed node in
  let given_here = Hashtbl.create 16 in
  List.iter2
    (fun (s : Ir.signal) is_given -> if is_given then Hashtbl.replace given_here s.id ())
    node.inputs given;
  let is_given id = Hashtbl.mem given_here (source id) in
  let probe (own, signal, ty, handed_down, span) =
    { name = ""; path = List.rev path; own; whole = List.rev whole; signal; ty; handed_down; span }
  in
  let own = List.map probe (own equations program node ~is_given ~source) in
  let is_handed_down (atom : Ir.atom) =
    match atom with Signal s -> is_given s.id | Bool _ | Int _ | Float _ -> false
  in
  let inner { step; word; index; inputs } rest =
    let given = List.map is_handed_down inputs in
    let whole = Option.to_list word @ whole in
    found equations passed program index ~path:(step :: path) ~whole ~given rest
  in
  own @ List.fold_right inner (inside program node) rest

(* Suffixes of the path to an instance, shortest first. *)
let rec ends whole =
  match whole with [] -> [] | _ :: rest -> ends rest @ [ String.concat "." whole ]

let named probes =
  let users = Hashtbl.create 256 in
  let instances = List.sort_uniq compare (List.map (fun p -> p.whole) probes) in
  let count name = Option.value (Hashtbl.find_opt users name) ~default:0 in
  List.iter
    (fun whole -> List.iter (fun name -> Hashtbl.replace users name (count name + 1)) (ends whole))
    instances;
  let shortest whole =
    let is_own name = count name = 1 in
    match List.find_opt is_own (ends whole) with
    | Some name -> name
    | None -> String.concat "." whole
  in
  let taken = Names.create () in
  let unique p = Names.unique taken (shortest p.whole ^ "." ^ p.signal) in
  List.map (fun p -> { p with name = unique p }) probes

let of_program equations (program : Ir.program) =
  if are_too_many program then None
  else
    let root = Array.length program.nodes - 1 in
    let node = program.nodes.(root) in
    let given = List.map (fun _ -> true) node.inputs in
    Some
      (named
         (found equations (passed_on program) program root ~path:[]
            ~whole:[ plain node.origin ]
            ~given []))

let modes_of (program : Ir.program) p =
  let rec follow (node : Ir.node) = function
    | [] -> node
    | Instance k :: path -> follow program.nodes.((List.nth node.instances k).node) path
    | Mode k :: path -> (
        match node.machine with
        | Some machine -> follow program.nodes.(List.nth machine.modes k) path
        | None -> node)
  in
  match (follow program.nodes.(Array.length program.nodes - 1) p.path).machine with
  | Some machine -> mode_names program machine
  | None -> []
