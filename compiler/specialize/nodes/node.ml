open Basis
module Ir = Flow.Ir

type t = {
  fresh : unit -> int;
  mutable equations : Ir.equation list; (* newest first *)
  mutable instances : Ir.instance list; (* newest first *)
  mutable size : int;
  mutable promised : Variables.Set.t; (* signals that have no equation yet *)
  mutable machine : Ir.machine option;
  instance_names : Names.t;
  mutable globals : Value.t Variables.t;
  mutable joins : Value.t Variables.t;
}

type target = Unnamed | Named of string | Defines of Ir.signal list

let create ~fresh =
  {
    fresh;
    equations = [];
    instances = [];
    size = 0;
    promised = Variables.Set.empty;
    machine = None;
    instance_names = Names.create ();
    globals = Variables.empty;
    joins = Variables.empty;
  }

let rec split count taken rest =
  match rest with
  | first :: others when count > 0 -> split (count - 1) (first :: taken) others
  | [] | _ :: _ -> (List.rev taken, rest)

let parts target table (parts : Types.part list) =
  match target with
  | Unnamed -> List.map (fun _ -> Unnamed) parts
  | Named name -> List.map (fun (p : Types.part) -> Named (Types.join name p.part)) parts
  | Defines signals ->
      let take (signals, targets) (p : Types.part) =
        let count = List.length (Types.layout table p.ty).leaves in
        let own, others = split count [] signals in
        (others, Defines own :: targets)
      in
      let _, targets = List.fold_left take (signals, []) parts in
      List.rev targets

let leaves target (leaves : Types.leaf list) =
  match target with
  | Unnamed -> List.map (fun _ -> Unnamed) leaves
  | Named name ->
      List.map (fun (l : Types.leaf) -> Named (Types.join name (Types.path_name l))) leaves
  | Defines signals -> List.map (fun signal -> Defines [ signal ]) signals

(* The cost of a signal, in steps, including its cost in all later passes. *)
let steps_of_signal = 30

(* A path is used as a name only if it starts with a name. The path of a component of an unnamed
   tuple starts with a number. *)
let signal t ~name ~span ty : Ir.signal =
  let is_position = String.length name > 0 && name.[0] >= '0' && name.[0] <= '9' in
  let name = if is_position then "" else name in
  let id = t.fresh () in
  Work.steps steps_of_signal;
  { id; name; ty; group = id; span }

let promise t ~name ~span leaves =
  List.map
    (fun (leaf : Types.leaf) ->
      let signal = signal t ~name:(Types.join name (Types.path_name leaf)) ~span leaf.leaf in
      t.promised <- Variables.Set.add signal.id t.promised;
      signal)
    leaves

(* The signal to define for a target with a single leaf. *)
let target_signal t target ~span ty =
  Work.step ();
  match target with
  | Defines [ signal ] ->
      t.promised <- Variables.Set.remove signal.Ir.id t.promised;
      signal
  | Named name -> signal t ~name ~span ty
  | Unnamed | Defines ([] | _ :: _ :: _) -> signal t ~name:"" ~span ty

let define t target ~span ty rhs =
  let signal = target_signal t target ~span ty in
  t.equations <- { defines = signal; rhs; span } :: t.equations;
  t.size <- t.size + 1;
  Ir.Signal signal

let settle t ~span signals atoms =
  List.iter2
    (fun (signal : Ir.signal) atom ->
      if Variables.Set.mem signal.id t.promised then
        ignore (define t (Defines [ signal ]) ~span signal.ty (Copy atom)))
    signals atoms

let call t targets ?loop ~callee ~node ~span ~statics ~inputs tys =
  let outputs = List.map2 (fun target ty -> target_signal t target ~span ty) targets tys in
  let name = Names.unique t.instance_names callee in
  t.instances <- { node; name; statics; inputs; outputs; loop; trials = []; span } :: t.instances;
  t.size <- t.size + 1;
  List.map (fun signal -> Ir.Signal signal) outputs

let set_machine t machine =
  t.machine <- Some machine;
  t.size <- t.size + 1

let machine t = t.machine
let size t = t.size
let equations t = List.rev t.equations
let instances t = List.rev t.instances
let global t key = Variables.find_opt key t.globals
let add_global t key value = t.globals <- Variables.add key value t.globals
let join t identity = Variables.find_opt identity t.joins
let add_join t identity value = t.joins <- Variables.add identity value t.joins
