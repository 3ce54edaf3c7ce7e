type seconds = Unlimited | Where_used | Both_ways
type t = { seconds : seconds array; nanoseconds : bool array }

let seconds t = Array.get t.seconds
let nanoseconds t = Array.get t.nanoseconds

(* One of the two times of a step: dt in seconds or dt in nanoseconds. *)
type time = {
  expr : Ir.expr;
  is_read : Ir.node -> bool;  (** whether the step or one of its callees reads it *)
  is_safe : Ir.node -> bool;  (** whether the step's own code limits the time at each use *)
}

(* How a step uses one of its two times. *)
type use = {
  itself : bool;
      (** whether it needs the limited time, for its own code or for everything that it calls *)
  steps : int list;  (** nodes, other than modes, whose steps receive the time from it *)
  modes : int list;  (** modes of its machine that read the time *)
  others : bool;  (** whether there are modes that do not read it *)
}

let use_of (program : Ir.program) time (node : Ir.node) =
  let reads k = time.is_read program.nodes.(k) in
  let modes, others = List.partition reads (List.map (fun (m : Ir.mode) -> m.node) node.modes) in
  let itself = ref false and steps = ref [] in
  let statement : Ir.statement -> unit = function
    | Step { node; _ } when reads node ->
        if Option.is_some program.nodes.(node).foreign then itself := true
        else steps := node :: !steps
    | Loop { node; _ } when reads node ->
        itself := true;
        steps := node :: !steps
    (* A machine with a clock passes its modes a time of its own. *)
    | Run { clock = Some _; _ } -> itself := true
    | Step _ | Loop _ | Run _ | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Return _ -> ()
  in
  Walk.statements statement node.step.body;
  if not (time.is_safe node) then
    Walk.expressions (fun e -> if e = time.expr then itself := true) node.step.body;
  let is_foreign k = Option.is_some program.nodes.(k).foreign in
  if List.exists is_foreign modes then itself := true;
  { itself = !itself; steps = !steps; modes; others = others <> [] }

(* Whether a step that uses the time in this way passes it on unlimited, so that limiting it is left
   to the callees. *)
let is_passed_on = function
  | { itself = false; steps = [] | [ _ ]; modes = []; others = _ } -> true
  | { itself = false; steps = []; modes = _ :: _; others } -> others
  | _ -> false

(* For each node, whether its step and its callees limit a time wherever they use it. *)
let safe (program : Ir.program) time =
  let safe ~before _ (node : Ir.node) =
    let is_safe k = (not (time.is_read program.nodes.(k))) || before k in
    let step : Ir.statement -> int list = function
      | Step { node; _ } | Loop { node; _ } -> [ node ]
      | Run _ -> List.map (fun (m : Ir.mode) -> m.node) node.modes
      | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Return _ -> []
    in
    let all = ref (Option.is_none node.foreign && time.is_safe node) in
    Walk.statements
      (function
        | Run { clock = Some _; _ } -> all := false
        | s -> if not (List.for_all is_safe (step s)) then all := false)
      node.step.body;
    !all
  in
  Basis.In_order.map ~stage:"Step.Dt_limits" safe program.nodes

(* The nodes whose steps receive an unlimited time, and those whose steps limit it at the start. *)
let limiting (program : Ir.program) time =
  let count = Array.length program.nodes in
  let limits = Array.make count false and unlimited = Array.make count false in
  let safe = safe program time in
  unlimited.(count - 1) <- true;
  (* Callers come after callees. *)
  for k = count - 1 downto 0 do
    let node = program.nodes.(k) in
    if unlimited.(k) && time.is_read node then
      let use = use_of program time node in
      if safe.(k) || is_passed_on use then
        List.iter (fun k -> unlimited.(k) <- true) (use.steps @ use.modes)
      else limits.(k) <- true
  done;
  (unlimited, limits)

let has_dt e =
  let found = ref false in
  Walk.expression (fun e -> if e = Ir.Dt then found := true) e;
  !found

(* Whether these statements use dt only if it is positive. *)
let rec is_guarded statements = List.for_all is_guarded_statement statements

and is_guarded_statement (s : Ir.statement) =
  match s with
  | If { condition = Operation { operator = Less; arguments = [ Float 0.; Dt ]; _ }; else_; _ } ->
      is_guarded else_
  | If { condition; then_; else_; _ } ->
      (not (has_dt condition)) && is_guarded then_ && is_guarded else_
  | Run _ | Declare _ | Assign _ | Step _ | Loop _ | Reset _ | Enter _ | Return _ ->
      let found = ref false in
      Walk.expressions (fun e -> if has_dt e then found := true) [ s ];
      not !found

let of_program (program : Ir.program) =
  let unlimited, limits =
    limiting program
      {
        expr = Dt;
        is_read = (fun node -> node.seconds);
        is_safe = (fun node -> is_guarded node.step.body);
      }
  in
  let seconds k is_unlimited =
    if limits.(k) then Both_ways else if is_unlimited then Where_used else Unlimited
  in
  let _, nanoseconds =
    limiting program
      {
        expr = Dt_nanoseconds;
        is_read = (fun node -> node.nanoseconds);
        is_safe = Short_times.only_advances program;
      }
  in
  { seconds = Array.mapi seconds unlimited; nanoseconds }
