open Basis

type options = { limit : int; depth : int }

let default = { limit = 10_000; depth = 5_000 }

type trail = { depth : int; calls : (string * Span.t) list (* the last one first *) }

let start = { depth = 0; calls = [] }

let entering ~name ~span trail =
  { depth = trail.depth + 1; calls = (name, span) :: trail.calls }

type definition = { core : Core.Ir.definition; code : int }

type specialization = {
  callee : callee;
  result : Value.t;
  outputs : Flow.Ir.atom list;
}

and callee =
  | Node of int
  | Nothing of Flow.Ir.signal list

type t = {
  sink : Diagnostic.sink;
  options : options;
  types : Types.table;
  free : Free.table;
  keys : Skeleton.table;
  fresh : unit -> int;
  definitions : (string * string, definition) Hashtbl.t;
  names : Names.t;
  globals : (int, Value.t) Hashtbl.t;
  specializations : (int, specialization) Hashtbl.t;
  counts : (string, int) Hashtbl.t;
  mutable nodes : Flow.Ir.node list;
  mutable node_count : int;
}

let create sink options (program : Core.Ir.program) =
  let next = ref 0 in
  let fresh () =
    incr next;
    !next
  in
  let types = Types.table program.data in
  let free = Free.table () in
  let definitions = Hashtbl.create 256 in
  List.iteri
    (fun i (core : Core.Ir.definition) ->
      Free.expr free core.body;
      Hashtbl.replace definitions (core.name.module_, core.name.name) { core; code = -i - 1 })
    program.definitions;
  {
    sink;
    options;
    types;
    free;
    keys = Skeleton.table types ~fresh;
    fresh;
    definitions;
    names = Names.create ();
    globals = Hashtbl.create 64;
    specializations = Hashtbl.create 256;
    counts = Hashtbl.create 64;
    nodes = [];
    node_count = 0;
  }

exception Stopped

(* The innermost calls: enough to see what goes on for ever. *)
let with_trail trail diagnostic =
  let rec labelled diagnostic shown = function
    | (name, at) :: others when shown < 5 ->
        labelled
          (Diagnostic.label ~at (Printf.sprintf "`%s` is called here" name) diagnostic)
          (shown + 1) others
    | [] | _ :: _ -> diagnostic
  in
  labelled diagnostic 0 trail.calls

let stop t trail diagnostic =
  Diagnostic.emit t.sink (with_trail trail diagnostic);
  raise Stopped

let check_depth t trail =
  match trail.calls with
  | (_, at) :: _ when trail.depth > t.options.depth ->
      stop t trail
        (Diagnostic.error ~code:"E0413" ~at "calls nest more than %d deep" t.options.depth)
  | [] | _ :: _ -> ()

let count t trail ~name ~span =
  let before = Option.value (Hashtbl.find_opt t.counts name) ~default:0 in
  Hashtbl.replace t.counts name (before + 1);
  if before >= t.options.limit then
    stop t trail
      (Diagnostic.error ~code:"E0413" ~at:span
         "`%s` is specialized for more than %d different arguments" name t.options.limit)

let add_node t node =
  let index = t.node_count in
  t.nodes <- node :: t.nodes;
  t.node_count <- index + 1;
  index
