open Basis
module Ir = Flow.Ir

type back = Instants of int | First | Entry
type source = { column : string; back : back; where_ : (string * int) option }

type transition = {
  from : int;
  target : int;
  label : string;
  delayed : bool;
  at_once : bool;
  sources : source list;
  place : Span.t;
}

type t = { column : string; place : Span.t; sources : source list; transitions : transition list }

let bug format = Diagnostic.bug ~stage:"Probe.Origin" format

(* Maximum number of past instants that are distinguished. Without a limit, the search would not
   terminate for a loop of delays. *)
let farthest = 2
let any = -1
let before = -2

(* {1 Node instances} *)

(* How a signal of a node is defined. *)
type definition =
  | Equation of Ir.equation
  | Given of int * int  (** an output of an instance: the numbers of the instance and the output *)
  | Chosen of int  (** the machine's output with this number *)
  | Input of int
  | Static of int

(* An instance of a node: its number, its node, the instance that contains it, and the step from
   that instance to this one. *)
type frame = { number : int; node : int; around : (frame * Catalogue.step) option }

type run = {
  program : Ir.program;
  definitions : (int, definition) Hashtbl.t option array;
      (** definitions of each node's signals, computed when first needed *)
  frames : (int * Catalogue.step, frame) Hashtbl.t;
  columns : (int * Catalogue.own, string) Hashtbl.t;  (** columns, by frame number *)
  inputs : (string * string) array;
      (** columns of the root's inputs: the text before and after the [[0]] of an array *)
  mutable count : int;
}

let node t frame = t.program.nodes.(frame.node)

let definitions t index =
  match t.definitions.(index) with
  | Some all -> all
  | None ->
      let node = t.program.nodes.(index) in
      let all = Hashtbl.create 32 in
      let add definition (s : Ir.signal) = Hashtbl.replace all s.id definition in
      List.iteri (fun k s -> add (Static k) s) node.statics;
      List.iteri (fun k s -> add (Input k) s) node.inputs;
      List.iter (fun (e : Ir.equation) -> add (Equation e) e.defines) node.equations;
      List.iteri
        (fun i (instance : Ir.instance) ->
          List.iteri (fun k s -> add (Given (i, k)) s) instance.outputs)
        node.instances;
      Option.iter
        (fun (m : Ir.machine) -> List.iteri (fun k s -> add (Chosen k) s) m.outputs)
        node.machine;
      t.definitions.(index) <- Some all;
      all

let machine_of node : Ir.machine =
  match (node : Ir.node).machine with Some m -> m | None -> bug "a mode without a machine"

let inside t frame (step : Catalogue.step) =
  match Hashtbl.find_opt t.frames (frame.number, step) with
  | Some inner -> inner
  | None ->
      let index =
        match step with
        | Instance k -> (List.nth (node t frame).instances k).node
        | Mode k -> List.nth (machine_of (node t frame)).modes k
      in
      t.count <- t.count + 1;
      let inner = { number = t.count; node = index; around = Some (frame, step) } in
      Hashtbl.replace t.frames (frame.number, step) inner;
      inner

let root t = { number = 0; node = Array.length t.program.nodes - 1; around = None }

(* {1 Following dependencies backwards} *)

(* The part of a value that is needed, as a path from the whole value inwards. The empty path
   represents the whole value. *)
type part =
  | Element of int  (** an element of an array *)
  | Leaf of int * int
      (** a constructor and the index of its leaf; matters only if the sum has this constructor *)
  | Tag  (** the tag of a sum *)

(* When a signal's value matters: how many instants ago, and in which mode of a machine. *)
type at = { back : back; where_ : (string * int) option }

type walk = {
  t : run;
  met : (int * int * at * part list, unit) Hashtbl.t;
  mutable found : source list;  (** in reverse order *)
}

let now = { back = Instants 0; where_ = None }

let add walk column { back; where_ } =
  let source : source = { column; back; where_ } in
  if not (List.mem source walk.found) then walk.found <- source :: walk.found

let earlier at =
  match at.back with
  | Instants n -> { at with back = Instants (min farthest (n + 1)) }
  | First | Entry -> at

let at_first at = match at.back with Instants _ -> { at with back = First } | First | Entry -> at

(* Prints the array indices at the start of a path. Column names do not show other parts. *)
let rec element = function
  | Element k :: part -> Printf.sprintf "[%d]" k ^ element part
  | (Leaf _ | Tag) :: _ | [] -> ""

let running_mode t frame = Hashtbl.find_opt t.columns (frame.number, Catalogue.Running_mode)

(* The transitions of a machine, each with the mode it leaves and the frame that its atoms belong
   to. *)
let transitions t frame =
  let machine = machine_of (node t frame) in
  let of_mode k index =
    let inner = inside t frame (Mode k) in
    List.map (fun e -> (k, inner, e)) t.program.nodes.(index).transitions
  in
  let around from = List.map (fun e -> (from, frame, e)) in
  around before machine.start @ around any machine.controls
  @ List.concat (List.mapi of_mode machine.modes)

let rec atom walk frame ~at ~part (atom : Ir.atom) =
  match atom with Signal s -> signal walk frame ~at ~part s | Bool _ | Int _ | Float _ -> ()

and signal walk frame ~at ~part (s : Ir.signal) =
  let key = (frame.number, s.id, at, part) in
  if not (Hashtbl.mem walk.met key) then (
    Hashtbl.replace walk.met key ();
    match Hashtbl.find_opt walk.t.columns (frame.number, Catalogue.Signal s) with
    | Some column -> add walk (column ^ element part) at
    | None -> definition walk frame ~at ~part s)

and definition walk frame ~at ~part (s : Ir.signal) =
  match Hashtbl.find_opt (definitions walk.t frame.node) s.id with
  | Some (Equation e) -> right_side walk frame ~at ~part e.rhs
  | Some (Given (k, output)) -> instance walk frame ~at ~part k output
  | Some (Chosen output) -> chosen walk frame ~at ~part output
  | Some (Input k) -> input walk frame ~at ~part k
  | Some (Static k) -> static walk frame ~at ~part k
  | None -> (
      (* The results of foreign code depend on all its inputs. *)
      match (node walk.t frame).foreign with
      | Some _ -> List.iteri (fun k _ -> input walk frame ~at ~part:[] k) (node walk.t frame).inputs
      | None -> bug "a signal of another node")

and right_side walk frame ~at ~part (rhs : Ir.rhs) =
  let go = atom walk frame ~at ~part in
  let all = List.iter (atom walk frame ~at ~part:[]) in
  let inner first a = atom walk frame ~at ~part:(first :: part) a in
  match (rhs, part) with
  | Copy a, _ | Fill a, [] -> go a
  | Fill a, _ :: part -> atom walk frame ~at ~part a
  | If { condition; then_; else_ }, _ ->
      all [ condition ];
      go then_;
      go else_
  | Construct { constructor; payload }, Leaf (c, k) :: part ->
      if c = constructor && k < List.length payload then
        atom walk frame ~at ~part (List.nth payload k)
  | Construct _, Tag :: _ -> ()
  | (Op (_, atoms) | Construct { payload = atoms; _ }), _ -> all atoms
  | Is_constructor (a, _), _ -> atom walk frame ~at ~part:[ Tag ] a
  | Payload { value; constructor; leaf }, _ -> inner (Leaf (constructor, leaf)) value
  | (Ticks a | Time { restart = a }), _ -> all [ a ]
  | Delay { init; next }, _ ->
      atom walk frame ~at:(at_first at) ~part init;
      atom walk frame ~at:(earlier at) ~part next
  | Elements atoms, Element k :: part when k < List.length atoms ->
      atom walk frame ~at ~part (List.nth atoms k)
  | Elements atoms, _ -> all atoms
  | Index (array, k), _ -> inner (Element k) array
  | At { array; index; default }, _ -> all [ index; array; default ]
  | Replace { array; index; value }, _ ->
      all [ index; value ];
      go array
  | (Param _ | Absent | Step_time), _ -> ()
  | Integral a, _ -> atom walk frame ~at:(earlier at) ~part:[] a
  | Derivative a, _ ->
      all [ a ];
      atom walk frame ~at:(earlier at) ~part:[] a

and instance walk frame ~at ~part k output =
  let instance = List.nth (node walk.t frame).instances k in
  let inner = inside walk.t frame (Instance k) in
  let part =
    match (instance.loop, part) with
    | None, _ -> part
    | Some _, Element _ :: rest -> rest
    | Some _, _ -> []
  in
  match walk.t.program.nodes.(instance.node) with
  | { foreign = Some _; inputs; _ } ->
      List.iteri (fun k _ -> input walk inner ~at ~part:[] k) inputs
  | callee -> atom walk inner ~at ~part (snd (List.nth callee.outputs output))

and chosen walk frame ~at ~part output =
  let machine = machine_of (node walk.t frame) in
  let column = running_mode walk.t frame in
  Option.iter (fun column -> add walk column at) column;
  List.iteri
    (fun k index ->
      let inner = inside walk.t frame (Mode k) in
      let value = snd (List.nth walk.t.program.nodes.(index).outputs output) in
      let at =
        match (column, at.back) with
        | Some column, (Instants _ | First) -> { at with where_ = Some (column, k) }
        | None, _ | _, Entry -> at
      in
      atom walk inner ~at ~part value)
    machine.modes

and input walk frame ~at ~part k =
  match frame.around with
  | None ->
      let before, after = walk.t.inputs.(k) in
      add walk (match element part with "" -> before | number -> before ^ number ^ after) at
  | Some (around, Instance i) ->
      let instance = List.nth (node walk.t around).instances i in
      let part = if Option.is_some instance.loop then [] else part in
      atom walk around ~at ~part (List.nth instance.inputs k)
  | Some (around, Mode _) ->
      let machine = machine_of (node walk.t around) in
      atom walk around ~at ~part (List.nth machine.inputs k)

(* The transition that enters a mode computes the mode's parameters. The search does not follow
   earlier transitions. *)
and static walk frame ~at ~part k =
  match frame.around with
  | None -> ()
  | Some (around, Instance i) ->
      let instance = List.nth (node walk.t around).instances i in
      atom walk around ~at ~part (List.nth instance.statics k)
  | Some (_, Mode _) when at.back = Entry -> ()
  | Some (around, Mode mode) ->
      let column = running_mode walk.t around in
      let given (from, frame, (e : Ir.transition)) =
        let where_ = Option.map (fun column -> (column, from)) column in
        if e.target = mode then
          atom walk frame ~at:{ back = Entry; where_ } ~part (List.nth e.arguments k)
      in
      List.iter given (transitions walk.t around)

let walk t continue =
  let walk = { t; met = Hashtbl.create 16; found = [] } in
  continue walk;
  List.rev walk.found

(* {1 Columns} *)

(* For each leaf of the input or output, the name that its columns share: the text before the index
   of an array element, and the text after it. *)
let rec leaf_columns name (shape : Ir.shape) =
  match shape with
  | Leaf _ -> [ (name, "") ]
  | Product { parts; constructor; record; _ } when constructor = "" || record ->
      let part k (field, shape) =
        leaf_columns (name ^ "." ^ if field = "" then string_of_int (k + 1) else field) shape
      in
      List.concat (List.mapi part parts)
  | Product { parts; _ } ->
      List.concat_map (fun (_, shape) -> leaf_columns name shape) parts
      |> List.map (fun _ -> (name, ""))
  | Repeated (_, element) ->
      let after (inner, _) =
        String.sub inner (String.length name) (String.length inner - String.length name)
      in
      List.map (fun leaf -> (name, after leaf)) (leaf_columns name element)

(* The columns of the output. If the program can end, its result is a separate part, next to the
   robot's command. *)
let output_columns (program : Ir.program) =
  match program.output with
  | Product { constructor = ""; parts = [ (_, command); (_, result) ]; _ } when program.ends ->
      leaf_columns "out" command @ leaf_columns "out.result" result
  | output -> leaf_columns "out" output

let label (e : Ir.transition) =
  match e.at_entry with Impossible (Some (event, _)) -> event | Impossible None | Possible -> ""

let machine_transitions t frame =
  List.map
    (fun (from, at, (e : Ir.transition)) ->
      {
        from;
        target = e.target;
        label = label e;
        delayed = e.delayed;
        at_once = (match e.at_entry with Possible -> true | Impossible _ -> false);
        sources = walk t (fun w -> atom w at ~at:now ~part:[] e.occurs);
        place = e.span;
      })
    (transitions t frame)

(* The place where a node gets its parameters or inputs. *)
let rec given t frame =
  match frame.around with
  | Some (around, Instance k) -> Some (List.nth (node t around).instances k).span
  | Some (around, Mode _) -> given t around
  | None -> None

let place t equations frame (p : Catalogue.probe) =
  match (Equations.whole equations p.span, p.own) with
  | Some whole, _ -> whole
  | None, Signal s -> (
      match (Hashtbl.find_opt (definitions t frame.node) s.id, frame.around) with
      | Some (Input _), _ | Some (Static _), Some (_, Instance _) ->
          Option.value (given t frame) ~default:p.span
      | Some (Static _ | Equation _ | Given _ | Chosen _), _ | None, _ -> p.span)
  | None, Running_mode -> p.span

let of_probe t equations frame column (p : Catalogue.probe) =
  let from_definition (s : Ir.signal) = walk t (fun w -> definition w frame ~at:now ~part:[] s) in
  match p.own with
  | Running_mode ->
      { column; place = p.span; sources = []; transitions = machine_transitions t frame }
  | Signal s ->
      { column; place = place t equations frame p; sources = from_definition s; transitions = [] }

let of_program equations (program : Ir.program) probes =
  let shown = List.filter (fun (p : Catalogue.probe) -> not p.handed_down) probes in
  let t =
    {
      program;
      definitions = Array.make (Array.length program.nodes) None;
      frames = Hashtbl.create 64;
      columns = Hashtbl.create 256;
      inputs = Array.of_list (leaf_columns "in" program.input);
      count = 0;
    }
  in
  let root = root t in
  let placed =
    List.map
      (fun (p : Catalogue.probe) -> (List.fold_left (inside t) root p.path, "probe." ^ p.name, p))
      shown
  in
  List.iter
    (fun (frame, column, (p : Catalogue.probe)) ->
      Hashtbl.replace t.columns (frame.number, p.own) column)
    placed;
  let root_node = node t root in
  let output (column, _) (_, value) =
    {
      column;
      place = root_node.span;
      sources = walk t (fun w -> atom w root ~at:now ~part:[] value);
      transitions = [];
    }
  in
  let outputs =
    let columns = output_columns program in
    if List.compare_lengths columns root_node.outputs = 0 then
      List.map2 output columns root_node.outputs
    else bug "an output without a column"
  in
  outputs @ List.map (fun (frame, column, p) -> of_probe t equations frame column p) placed
