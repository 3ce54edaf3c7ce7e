open Basis
module Ir = Flow.Ir

type source = Start | Any | State of int

type arrow = {
  source : source;
  target : int;
  label : string;
  may_be_immediate : bool;
  delayed : bool;
}

type state = { name : string; place : string; inside : int list }
type t = { title : string; states : state list; arrows : arrow list }

(* The nodes that have a machine and run inside this node, including the node itself. Excludes nodes
   that run inside a mode of its own machine. *)
let inside (program : Ir.program) index =
  let rec from found index =
    let node = program.nodes.(index) in
    List.fold_left
      (fun found (i : Ir.instance) ->
        match program.nodes.(i.node).machine with
        | Some _ when not (List.mem i.node found) -> from (i.node :: found) i.node
        | _ -> from found i.node)
      found node.instances
  in
  let own = if Option.is_some program.nodes.(index).machine then [ index ] else [] in
  List.rev (from own index)

let place ~file (span : Span.t) =
  if String.equal span.file file then Printf.sprintf "line %d" (Span.line span.start)
  else Printf.sprintf "%s:%d" (Filename.basename span.file) (Span.line span.start)

let arrow source (t : Ir.transition) =
  let may_be_immediate, label =
    match (source, t.at_entry) with
    | State _, Possible -> (true, "")
    | State _, Impossible (Some (event, _)) -> (false, event)
    | (State _ | Start | Any), _ -> (false, "")
  in
  { source; target = t.target; label; may_be_immediate; delayed = t.delayed && source <> Start }

let machine (program : Ir.program) ~file ~number (node : Ir.node) (m : Ir.machine) =
  let state index =
    let mode = program.nodes.(index) in
    {
      name = mode.origin;
      place = place ~file mode.span;
      inside = List.map number (inside program index);
    }
  in
  let from_state k index = List.map (arrow (State k)) program.nodes.(index).transitions in
  {
    title =
      Printf.sprintf "%s, %s:%d" node.origin (Filename.basename m.span.file)
        (Span.line m.span.start);
    states = List.map state m.modes;
    arrows =
      List.map (arrow Start) m.start
      @ List.map (arrow Any) m.controls
      @ List.concat (List.mapi from_state m.modes);
  }

let of_program (program : Ir.program) =
  let numbers = Hashtbl.create 16 in
  Array.iteri
    (fun index (node : Ir.node) ->
      if Option.is_some node.machine then Hashtbl.replace numbers index (Hashtbl.length numbers))
    program.nodes;
  let file =
    match Array.length program.nodes with 0 -> "" | n -> program.nodes.(n - 1).span.file
  in
  let of_node (node : Ir.node) =
    Option.map (machine program ~file ~number:(Hashtbl.find numbers) node) node.machine
  in
  List.filter_map of_node (Array.to_list program.nodes)
