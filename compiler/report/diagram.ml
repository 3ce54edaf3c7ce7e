open Basis
module Ir = Flow.Ir

let quoted text =
  let out = Buffer.create 32 in
  String.iter
    (function
      | ('"' | '\\') as c ->
          Buffer.add_char out '\\';
          Buffer.add_char out c
      | '\n' -> Buffer.add_string out "\\n"
      | c -> Buffer.add_char out c)
    text;
  "\"" ^ Buffer.contents out ^ "\""

(* Machines and states are identified by numbers; the number of a state is unique within its
   machine. *)
let start number = Printf.sprintf "start%d" number
let any number = Printf.sprintf "any%d" number
let state number mode = Printf.sprintf "state%d_%d" number mode

let attributes list =
  match List.filter (fun (_, value) -> value <> "") list with
  | [] -> ""
  | list ->
      let one (name, value) = name ^ "=" ^ value in
      Printf.sprintf " [%s]" (String.concat ", " (List.map one list))

let line_of ~file (span : Span.t) =
  if String.equal span.file file then Printf.sprintf "line %d" (Span.line span.start)
  else Printf.sprintf "%s:%d" (Filename.basename span.file) (Span.line span.start)

let label (t : Ir.transition) =
  match t.at_entry with Impossible (Some (event, _)) -> event | Impossible None | Possible -> ""

let edge ppf number ~from (t : Ir.transition) =
  let dashed = match t.at_entry with Possible -> true | Impossible _ -> false in
  let text = label t in
  Format.fprintf ppf "    %s -> %s%s;@." from (state number t.target)
    (attributes
       [
         ("label", if text = "" then "" else quoted text);
         ("style", if dashed then "dashed" else "");
         ("arrowhead", if t.delayed then "onormal" else "");
       ])

let machine ppf (program : Ir.program) ~file number (node : Ir.node) (m : Ir.machine) =
  let title =
    Printf.sprintf "%s, %s:%d" node.origin (Filename.basename m.span.file) (Span.line m.span.start)
  in
  Format.fprintf ppf "  subgraph cluster%d {@.    label=%s;@." number (quoted title);
  Format.fprintf ppf "    %s [shape=point];@." (start number);
  List.iteri
    (fun k index ->
      let mode = program.nodes.(index) in
      let text = mode.origin ^ "\n" ^ line_of ~file mode.span in
      Format.fprintf ppf "    %s [label=%s];@." (state number k) (quoted text))
    m.modes;
  let first (t : Ir.transition) =
    Format.fprintf ppf "    %s -> %s;@." (start number) (state number t.target)
  in
  List.iter first m.start;
  if m.controls <> [] then Format.fprintf ppf "    %s [label=any, shape=plaintext];@." (any number);
  List.iter
    (fun (t : Ir.transition) ->
      Format.fprintf ppf "    %s -> %s%s;@." (any number) (state number t.target)
        (attributes [ ("arrowhead", if t.delayed then "onormal" else "") ]))
    m.controls;
  List.iteri
    (fun k index ->
      List.iter (edge ppf number ~from:(state number k)) program.nodes.(index).transitions)
    m.modes;
  Format.fprintf ppf "  }@."

(* Nodes with a machine that run inside a node, but not inside a mode of the node's own machine. *)
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

let print ppf (program : Ir.program) =
  let numbers = Hashtbl.create 16 in
  Array.iteri
    (fun index (node : Ir.node) ->
      if Option.is_some node.machine then Hashtbl.replace numbers index (Hashtbl.length numbers))
    program.nodes;
  let file =
    match Array.length program.nodes with 0 -> "" | n -> program.nodes.(n - 1).span.file
  in
  Format.fprintf ppf "digraph %s {@.  node [shape=box, style=rounded];@." (quoted program.name);
  let each f =
    Array.iteri
      (fun index (node : Ir.node) ->
        match node.machine with Some m -> f (Hashtbl.find numbers index) node m | None -> ())
      program.nodes
  in
  each (machine ppf program ~file);
  each (fun number _ m ->
      List.iteri
        (fun k index ->
          List.iter
            (fun inner ->
              Format.fprintf ppf "  %s -> %s [style=dotted, arrowhead=none];@." (state number k)
                (start (Hashtbl.find numbers inner)))
            (inside program index))
        m.modes);
  Format.fprintf ppf "}@."
