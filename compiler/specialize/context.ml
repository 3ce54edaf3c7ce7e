open Basis
module Global_table = Resolve.Global_table

type options = { limit : int; nesting : int; depth : int; work : int; marks : int option }

let default = { limit = 10_000; nesting = 1_000; depth = 5_000; work = 25_000_000; marks = None }

type expansion = { by : string; elements : int; at : Span.t }
type machine = { of_ : string; place : Span.t; mutable modes : int }
type wide = { ty : Core.Ir.ty; leaves : int; mutable uses : int }

(* The calls that lead to a place. The latest element of each list is first. *)
type trail = {
  depth : int;
  calls : (string * Span.t) list;
  expansions : expansion list;
  machines : machine list;
}

let start = { depth = 0; calls = []; expansions = []; machines = [] }

type definition = { core : Core.Ir.definition; code : int }

type specialization = { callee : callee; result : Value.t; outputs : Flow.Ir.atom list }
and callee = Node of int | Nothing of Flow.Ir.signal list

type console =
  | Sought of { mutable found : Core.Ir.control list }
  | Declared of Core.Ir.control list

type t = {
  facts : Fact.t Facts.t;
  mutable failed : bool;
  real : Real.t;
  foreign : Core.Ir.foreign;
  console : console;
  constants : Core.Constant_numbers.t;
  options : options;
  types : Types.table;
  free : Free.table;
  keys : Specialization_key.table;
  fresh : unit -> int;
  instances : Core.Instance.table;
  definitions : definition Global_table.t;
  params : Core.Ir.param list;
  param_numbers : int Global_table.t;
  names : Names.t;
  globals : Value.t Variables.Table.t;
  begun : unit Variables.Table.t;
  specializations : specialization Variables.Table.t;
  building : trail Variables.Table.t;
  counts : int String_table.t;
  mutable nodes : Flow.Ir.node list;
  mutable kept : Span.t list;
  mutable controls : Control_fact.t list;
  mutable node_count : int;
  called : int ref String_table.t;
  wide : wide Int_table.t;
  mutable latest : trail;
  size : int;
  mutable draws : bool;
}

let create facts options ?(seeks = false) (program : Core.Ir.program) =
  let next = ref 0 in
  let fresh () =
    incr next;
    !next
  in
  let types = Types.table ~marks:options.marks program in
  let free = Free.table () in
  let constants = Core.Constant_numbers.of_program program in
  let param_numbers = Global_table.create 16 in
  List.iteri
    (fun k (p : Core.Ir.param) -> Global_table.replace param_numbers p.param k)
    program.params;
  let definitions = Global_table.create 256 in
  (* Code numbers are smaller than the ids of all locals, including the negative ids of unnamed
     locals. *)
  List.iteri
    (fun i (core : Core.Ir.definition) ->
      Free.expr free core.body;
      Global_table.replace definitions core.name { core; code = min_int + i })
    program.definitions;
  {
    facts;
    failed = false;
    real = program.real;
    foreign = program.foreign;
    console = (if seeks then Sought { found = [] } else Declared program.console);
    constants;
    options;
    types;
    free;
    keys = Specialization_key.table types ~constants ~fresh;
    fresh;
    instances = Core.Instance.table program.instances;
    definitions;
    params = program.params;
    param_numbers;
    names = Names.create ();
    globals = Variables.Table.create 64;
    begun = Variables.Table.create 16;
    specializations = Variables.Table.create 256;
    building = Variables.Table.create 16;
    counts = String_table.create 64;
    nodes = [];
    kept = [];
    controls = [];
    node_count = 0;
    called = String_table.create 64;
    wide = Int_table.create 16;
    latest = start;
    size = Free.size free;
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
let calls trail = trail.calls

let report t fact =
  t.failed <- true;
  Facts.report t.facts fact

let stop t fact =
  report t fact;
  raise Stopped

let enter t trail ~name ~span =
  let trail = { trail with depth = trail.depth + 1; calls = (name, span) :: trail.calls } in
  t.latest <- trail;
  (match String_table.find_opt t.called name with
  | Some count -> incr count
  | None -> String_table.replace t.called name (ref 1));
  if trail.depth > t.options.depth then
    stop t (Limit { at = span; calls = trail.calls; excess = Calls_nested t.options.depth });
  trail

(* {1 Causes of excessive work} *)

(* Minimum cost of one element, in steps. *)
let steps_of_element = 50

let expanding t trail ~by ~elements ~span =
  let trail = { trail with expansions = { by; elements; at = span } :: trail.expansions } in
  t.latest <- trail;
  Work.steps (steps_of_element * elements);
  trail

(* Types with fewer leaves are not worth reporting. *)
let least_wide = 100

let defining t trail ty =
  let { Types.id; leaves; _ } = Types.layout t.types ty in
  let leaves = List.length leaves in
  if leaves >= least_wide then (
    t.latest <- trail;
    match Int_table.find_opt t.wide id with
    | Some wide -> wide.uses <- wide.uses + 1
    | None -> Int_table.replace t.wide id { ty; leaves; uses = 1 })

let widest t =
  let all wide = wide.uses * wide.leaves in
  Int_table.fold
    (fun _ wide best ->
      match best with Some other when all other >= all wide -> best | Some _ | None -> Some wide)
    t.wide None

let in_machine trail machine = { trail with machines = machine :: trail.machines }
let expansions trail = trail.expansions
let machines trail = trail.machines
let latest t = t.latest

let most table count =
  String_table.fold
    (fun name found best ->
      match best with
      | Some (other, most) when most > count name found || (most = count name found && other < name)
        ->
          best
      | Some _ | None -> Some (name, count name found))
    table None

(* Skips operators, because the names of the surrounding functions are more informative. *)
let has_letters name =
  String.length name > 0 && match name.[0] with 'a' .. 'z' | 'A' .. 'Z' | '_' -> true | _ -> false

let most_called t = most t.called (fun name calls -> if has_letters name then !calls else 0)
let most_specialized t = most t.counts (fun _ copies -> copies)

(* The limit grows with the length of the program, so that each expression can be evaluated and
   specialized a few times. *)
let steps_of_expression = 100

let allowed_work t =
  let own = t.options.work + (steps_of_expression * t.size) in
  if t.options.limit > default.limit then own / default.limit * t.options.limit else own

(* The innermost call in the program's folder, which is the folder of the outermost call. *)
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

let report_control t fact =
  if not (List.mem fact t.controls) then (
    t.controls <- fact :: t.controls;
    report t (Control fact))

let report_stored t trail ~span ty =
  let by, calls =
    match own_call trail ~span with
    | Some (name, at, calls) -> (Some (name, at), calls)
    | None -> (None, trail.calls)
  in
  report t (Stored { at = span; calls; ty; by })

let check_lasting t trail ~span tys =
  let is_reported (_, at) = List.mem at t.kept in
  match List.find_map (Types.of_the_instant t.types) tys with
  | None -> ()
  | Some _ when List.exists is_reported (("", span) :: trail.calls) -> ()
  | Some ty ->
      t.kept <- span :: t.kept;
      report t (Of_the_instant { at = span; calls = trail.calls; ty })

let count t trail ~name ~span =
  let before = Option.value (String_table.find_opt t.counts name) ~default:0 in
  String_table.replace t.counts name (before + 1);
  if before >= t.options.limit then
    (* A mode is determined by the running task and by everything that follows it. *)
    let inside =
      match trail.machines with
      | { of_; modes; _ } :: _ when modes > t.options.limit / 2 -> Some { Limit_fact.of_; modes }
      | [] | _ :: _ -> None
    in
    let excess = Limit_fact.Specializations { name; limit = t.options.limit; inside } in
    stop t (Limit { at = span; calls = trail.calls; excess })

let add_node t node =
  let index = t.node_count in
  t.nodes <- node :: t.nodes;
  t.node_count <- index + 1;
  index
