open Ir

(* A parameter of the mode that is this node. *)
type found = { mode : int; index : int;  (** of the mode's parameters *) variable : variable; field : field }

let codes (node : node) = node.reset.body :: node.step.body :: (match node.start with Some s -> [ s.body ] | None -> [])

(* Its reads, and how many of them only ask whether a time has come to it. *)
let asks (v : variable) (code : code) =
  let reads = ref 0 and comparisons = ref 0 in
  Walk.expressions
    (function
      | Variable w when w.id = v.id -> incr reads
      | Operation { operator = Less_equal; arguments = [ Variable w; In_nanoseconds _ ]; _ }
        when w.id = v.id ->
          incr comparisons
      | _ -> ())
    code.body;
  !reads > 0 && !reads = !comparisons

let is_given (v : variable) (code : code) =
  List.exists (fun (p : variable) -> p.id = v.id) code.parameters

let least real = function Float x -> Flow.Clock.reaches real x | _ -> None

(* What the machine of [owner] enters the mode with, in its place. *)
let always_literal (program : program) (owner : node) { mode; index; _ } =
  let all = ref true in
  let entry (e : entry) =
    if (List.nth owner.modes e.mode).node = mode && least program.real (List.nth e.parameters index) = None
    then all := false
  in
  List.iter (Walk.entries entry) (codes owner);
  !all

let of_machine (program : program) (owner : node) =
  let of_mode (mode : mode) =
    let node = program.nodes.(mode.node) in
    let elsewhere v =
      is_given v node.reset || Option.fold node.start ~none:false ~some:(is_given v)
    in
    let candidate index (variable, field) = { mode = mode.node; index; variable; field } in
    List.filter
      (fun ({ variable; _ } as found) ->
        variable.ty = Float && asks variable node.step
        && (not (elsewhere variable))
        && always_literal program owner found)
      (List.mapi candidate mode.parameters)
  in
  List.concat_map of_mode owner.modes

let renamed name = if String.equal name "" then name else name ^ "_ns"
let counted (v : variable) = { v with ty = Nanoseconds; name = renamed v.name }

let kept (field : field) =
  { field with content = Value Nanoseconds; name = renamed field.name }

let map_code ~expression ~entry (code : code) =
  { code with body = Walk.map_statements ~expression ~entry code.body }

(* The node of the machine: where the parameter is kept, and with what it is entered. *)
let in_owner real found (owner : node) =
  let is_one (field : field) = List.exists (fun f -> f.field.id = field.id) found in
  let parameter (v, field) = if is_one field then (counted v, kept field) else (v, field) in
  let mode (m : mode) = { m with parameters = List.map parameter m.parameters } in
  let state (field : field) =
    match field.content with
    | Modes modes -> { field with content = Modes (List.map mode modes) }
    | Value _ | State_of _ | States_of _ | Running_mode | Component _ -> field
  in
  let rec expression e =
    match e with
    | Field field when is_one field -> Field (kept field)
    | e -> Walk.map_children expression e
  in
  let entry (e : entry) =
    let value (_, field) given =
      match if is_one field then least real given else None with
      | Some ns -> Time ns
      | None -> given
    in
    { e with parameters = List.map2 value (List.nth owner.modes e.mode).parameters e.parameters }
  in
  let code = map_code ~expression ~entry in
  {
    owner with
    modes = List.map mode owner.modes;
    state = List.map state owner.state;
    reset = code owner.reset;
    step = code owner.step;
    start = Option.map code owner.start;
  }

(* The node of the mode: what it compares. *)
let in_mode found (node : node) =
  let is_one (v : variable) = List.exists (fun f -> f.variable.id = v.id) found in
  let rec expression e =
    match e with
    | Operation { operator = Less_equal; arguments = [ Variable v; In_nanoseconds time ]; _ }
      when is_one v ->
        Operation
          {
            operator = Less_equal;
            ty = Nanoseconds;
            arguments = [ Variable (counted v); expression time ];
          }
    | e -> Walk.map_children expression e
  in
  let step = map_code ~expression ~entry:Fun.id node.step in
  let parameter v = if is_one v then counted v else v in
  { node with step = { step with parameters = List.map parameter step.parameters } }

let program (program : program) =
  let nodes = Array.copy program.nodes in
  let changed = ref false in
  Array.iteri
    (fun k _ ->
      match of_machine program nodes.(k) with
      | [] -> ()
      | found ->
          changed := true;
          nodes.(k) <- in_owner program.real found nodes.(k);
          List.iter
            (fun f ->
              let of_mode = List.filter (fun other -> other.mode = f.mode) found in
              nodes.(f.mode) <- in_mode of_mode nodes.(f.mode))
            found)
    program.nodes;
  if !changed then { program with nodes } else program
