open Basis
module Global_table = Resolve.Global_table

type options = { limit : int; nesting : int; depth : int; work : int; marks : int option }

let default = { limit = 10_000; nesting = 1_000; depth = 5_000; work = 3_000_000; marks = None }

type trail = { depth : int; calls : (string * Span.t) list (* the last one first *) }

let start = { depth = 0; calls = [] }

type definition = { core : Core.Ir.definition; code : int }

type specialization = { callee : callee; result : Value.t; outputs : Flow.Ir.atom list }
and callee = Node of int | Nothing of Flow.Ir.signal list

type console =
  | Sought of { mutable found : Core.Ir.control list }
  | Declared of Core.Ir.control list

type t = {
  sink : Diagnostic.sink;
  real : Real.t;
  foreign : Core.Ir.foreign;
  console : console;
  constants : Core.Constant_numbers.t;
  options : options;
  types : Types.table;
  free : Free.table;
  keys : Skeleton.table;
  fresh : unit -> int;
  instances : Core.Instance.table;
  definitions : definition Global_table.t;
  params : Core.Ir.param list;
  names : Names.t;
  globals : Value.t Variables.Table.t;
  begun : unit Variables.Table.t;
  specializations : specialization Variables.Table.t;
  building : trail Variables.Table.t;
  counts : int String_table.t;
  mutable nodes : Flow.Ir.node list;
  mutable kept : Span.t list;
  mutable reported : (string * Span.t) list;
  mutable node_count : int;
  mutable entered : int;
  mutable draws : bool;
}

let create sink options ?(seeks = false) (program : Core.Ir.program) =
  let next = ref 0 in
  let fresh () =
    incr next;
    !next
  in
  let types = Types.table ~marks:options.marks program in
  let free = Free.table () in
  let constants = Core.Constant_numbers.of_program program in
  let definitions = Global_table.create 256 in
  (* Below the ids of all locals: those without a name are negative too. *)
  List.iteri
    (fun i (core : Core.Ir.definition) ->
      Free.expr free core.body;
      Global_table.replace definitions core.name { core; code = min_int + i })
    program.definitions;
  {
    sink;
    real = program.real;
    foreign = program.foreign;
    console = (if seeks then Sought { found = [] } else Declared program.console);
    constants;
    options;
    types;
    free;
    keys = Skeleton.table types ~constants ~fresh;
    fresh;
    instances = Core.Instance.table program.instances;
    definitions;
    params = program.params;
    names = Names.create ();
    globals = Variables.Table.create 64;
    begun = Variables.Table.create 16;
    specializations = Variables.Table.create 256;
    building = Variables.Table.create 16;
    counts = String_table.create 64;
    nodes = [];
    kept = [];
    reported = [];
    node_count = 0;
    entered = 0;
    draws = false;
  }

let identity : Core.Ir.Global.t = { module_ = "Prelude"; name = "id" }
let known_by_name = [ identity; Core.Signature.reading ]

let in_prelude (c : t) (at : Span.t) =
  match Global_table.find_opt c.definitions identity with
  | Some { core; _ } -> String.equal core.span.file at.file
  | None -> false

let in_library (c : t) (at : Span.t) =
  match Global_table.find_opt c.definitions identity with
  | Some { core; _ } -> String.equal (Filename.dirname core.span.file) (Filename.dirname at.file)
  | None -> false

exception Stopped
exception Postponed of (unit -> unit)

let rec settle evaluate =
  match evaluate () with
  | () -> ()
  | exception Postponed first ->
      settle first;
      settle evaluate

let from_here trail = { trail with depth = 0 }

let since earlier later =
  let rec go found calls =
    if calls == earlier.calls then List.rev found
    else match calls with [] -> List.rev found | call :: others -> go (call :: found) others
  in
  go [] later.calls

let nests_deeply t trail = trail.depth > t.options.nesting

(* The innermost calls, each place once: enough to see what goes on for ever. *)
let with_trail trail diagnostic =
  let rec labelled diagnostic shown = function
    | (name, at) :: others when List.length shown < 5 ->
        if List.mem at shown then labelled diagnostic shown others
        else
          let text = Printf.sprintf "`%s` is called here" name in
          labelled (Diagnostic.label ~at text diagnostic) (at :: shown) others
    | [] | _ :: _ -> diagnostic
  in
  labelled diagnostic [] trail.calls

let stop t trail diagnostic =
  Diagnostic.emit t.sink (with_trail trail diagnostic);
  raise Stopped

let enter t trail ~name ~span =
  let trail = { depth = trail.depth + 1; calls = (name, span) :: trail.calls } in
  t.entered <- t.entered + 1;
  if trail.depth > t.options.depth then
    stop t trail
      (Diagnostic.error ~code:"E0413" ~at:span "calls nest more than %d deep" t.options.depth);
  if t.entered > t.options.work then
    stop t trail
      (Diagnostic.error ~code:"E0413" ~at:span "more than %d calls are evaluated while compiling"
         t.options.work);
  trail

let report_outside t trail ~span ~index ~size =
  Diagnostic.error ~code:"E0418" ~at:span "index %d is outside of an array of %d" index size
  |> Diagnostic.note
       (if size = 1 then "its only element has the number 0"
        else Printf.sprintf "the elements are numbered from 0 to %d" (size - 1))
  |> with_trail trail |> Diagnostic.emit t.sink

(* The innermost call in the folder of the outermost: the program's own. *)
let own_call trail ~span =
  let rec outermost = function [] -> span | [ (_, at) ] -> at | _ :: calls -> outermost calls in
  let folder (at : Span.t) = Filename.dirname at.file in
  let is_own at = String.equal (folder at) (folder (outermost trail.calls)) in
  let rec own = function
    | (name, at) :: calls -> if is_own at then Some (name, at, calls) else own calls
    | [] -> None
  in
  if is_own span then None else own trail.calls

let own_place t trail ~span =
  let is_own (_, at) = not (in_library t at) in
  Option.fold (List.find_opt is_own (("", span) :: trail.calls)) ~none:span ~some:snd

let report_once t ~code ~at diagnostic =
  if not (List.mem (code, at) t.reported) then (
    t.reported <- (code, at) :: t.reported;
    Diagnostic.emit t.sink diagnostic)

let report_stored t trail ~span ty =
  (match own_call trail ~span with
  | Some (name, at, calls) ->
      Diagnostic.error ~code:"E0412" ~at "`%s` cannot keep a value of type `%s`" name ty
      |> Diagnostic.label ~at:span "it would be stored here, in a `delay`"
      |> with_trail { trail with calls }
  | _ ->
      Diagnostic.error ~code:"E0412" ~at:span "a value of type `%s` cannot be stored in a `delay`"
        ty
      |> with_trail trail)
  |> Diagnostic.note "functions, signal functions and labels exist only while compiling"
  |> Diagnostic.emit t.sink

let check_lasting t trail ~span tys =
  let is_reported (_, at) = List.mem at t.kept in
  match List.find_map (Types.of_the_instant t.types) tys with
  | None -> ()
  | Some _ when List.exists is_reported (("", span) :: trail.calls) -> ()
  | Some foreign when Flow.Shape.is_image foreign ->
      t.kept <- span :: t.kept;
      Diagnostic.error ~code:"E0430" ~at:span "an image would be kept here"
      |> Diagnostic.note "a camera's memory is used again for its next frames"
      |> Diagnostic.hint
           "keep the numbers that you need, not the picture: look for them at the instant at which \
            the frame comes, and `hold` what was found"
      |> with_trail trail |> Diagnostic.emit t.sink
  | Some { foreign_name = name; _ } ->
      t.kept <- span :: t.kept;
      Diagnostic.error ~code:"E0430" ~at:span "a value of the foreign type `%s` would be kept here"
        name
      |> Diagnostic.note
           (Printf.sprintf "C gives a `%s` for one instant, and may use its memory again after it"
              name)
      |> Diagnostic.hint
           (Printf.sprintf
              "keep what you need of it; or declare the type `copyable`, if a copy of the struct \
               is as good as the struct")
      |> with_trail trail |> Diagnostic.emit t.sink

let count t trail ~name ~span =
  let before = Option.value (String_table.find_opt t.counts name) ~default:0 in
  String_table.replace t.counts name (before + 1);
  if before >= t.options.limit then
    stop t trail
      (Diagnostic.error ~code:"E0413" ~at:span
         "`%s` is specialized for more than %d different arguments" name t.options.limit
      |> Diagnostic.note
           "it has a copy for each type, function and signal function that it is given, not for \
            each number"
      |> Diagnostic.hint "the option `--specialization-limit` allows more")

let add_node t node =
  let index = t.node_count in
  t.nodes <- node :: t.nodes;
  t.node_count <- index + 1;
  index
