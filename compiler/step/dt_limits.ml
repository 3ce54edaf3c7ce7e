type seconds = Unlimited | At_most | Both_ways
type nanoseconds = Unlimited | To_31_bits | To_largest
type t = { seconds : seconds array; nanoseconds : nanoseconds array }

let seconds t = Array.get t.seconds
let nanoseconds t = Array.get t.nanoseconds

(* What a step does with one of its times. *)
type use = {
  itself : bool;  (** it needs the time limited, for its own code or for all that it calls *)
  steps : int list;  (** nodes whose steps it passes the time to, except for modes *)
  modes : int list;  (** modes of its machine that read the time *)
  others : bool;  (** some modes do not read it *)
}

let use_of (program : Ir.program) ~reads ~time k =
  let node = program.nodes.(k) in
  let reads k = reads program.nodes.(k) in
  let modes, others = List.partition reads (List.map (fun (m : Ir.mode) -> m.node) node.modes) in
  let itself = ref false and steps = ref [] in
  let statement : Ir.statement -> unit = function
    | Step { node; _ } when reads node ->
        if Option.is_some program.nodes.(node).foreign then itself := true
        else steps := node :: !steps
    | Loop { node; _ } when reads node -> itself := true
    (* Such a machine has a time of its own. *)
    | Run { clock = Some _; _ } -> itself := true
    | Step _ | Loop _ | Run _ | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Return _ -> ()
  in
  Walk.statements statement node.step.body;
  Walk.expressions (fun e -> if e = time then itself := true) node.step.body;
  let is_foreign k = Option.is_some program.nodes.(k).foreign in
  if List.exists is_foreign modes then itself := true;
  { itself = !itself; steps = !steps; modes; others = others <> [] }

(* Whether the callees limit the time, instead of a step with this use. *)
let is_passed_on = function
  | { itself = false; steps = [ _ ]; modes = []; others = _ } -> true
  | { itself = false; steps = []; modes = _ :: _; others } -> others
  | _ -> false

(* The nodes whose steps limit a time. *)
let limiting (program : Ir.program) ~reads ~time =
  let count = Array.length program.nodes in
  let limits = Array.make count false and unlimited = Array.make count false in
  unlimited.(count - 1) <- true;
  (* Callers come after callees. *)
  for k = count - 1 downto 0 do
    if unlimited.(k) && reads program.nodes.(k) then
      let use = use_of program ~reads ~time k in
      if is_passed_on use then List.iter (fun k -> unlimited.(k) <- true) (use.steps @ use.modes)
      else limits.(k) <- true
  done;
  limits

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
  | Run { clock = Some _; _ } -> false
  | Run _ | Declare _ | Assign _ | Step _ | Loop _ | Reset _ | Enter _ | Return _ ->
      let found = ref false in
      Walk.expressions (fun e -> if has_dt e then found := true) [ s ];
      not !found

(* For each node, whether its step and its callees use dt only if it is positive. *)
let only_positive (program : Ir.program) =
  let positive ~before _ (node : Ir.node) =
    let is_positive k = (not program.nodes.(k).seconds) || before k in
    let step : Ir.statement -> int list = function
      | Step { node; _ } | Loop { node; _ } -> [ node ]
      | Run _ -> List.map (fun (m : Ir.mode) -> m.node) node.modes
      | Declare _ | Assign _ | If _ | Reset _ | Enter _ | Return _ -> []
    in
    let all = ref (Option.is_none node.foreign && is_guarded node.step.body) in
    Walk.statements
      (fun s -> if not (List.for_all is_positive (step s)) then all := false)
      node.step.body;
    !all
  in
  Basis.In_order.map ~stage:"Step.Dt_limits" positive program.nodes

let of_program (program : Ir.program) =
  let limits = limiting program ~reads:(fun node -> node.seconds) ~time:Dt in
  let positive = only_positive program in
  let seconds k limits : seconds =
    if not limits then Unlimited else if positive.(k) then At_most else Both_ways
  in
  let is_short = Short_times.is_dt_short program in
  let nanoseconds limits =
    if not limits then Unlimited else if is_short then To_31_bits else To_largest
  in
  let in_nanoseconds =
    limiting program ~reads:(fun node -> node.nanoseconds) ~time:Dt_nanoseconds
  in
  { seconds = Array.mapi seconds limits; nanoseconds = Array.map nanoseconds in_nanoseconds }
