open Basis
module Ir = Flow.Ir

let bug format = Diagnostic.bug ~stage:"Probe.Observed" format

(* A path that leads from a node down to an inner node, and the signal at its end. *)
type wanted = { path : Catalogue.step list; own : own; label : string }
and own = Signal of int  (** id of the signal *) | Running_mode

let own : Catalogue.own -> own = function Signal s -> Signal s.id | Running_mode -> Running_mode

(* Two requests with the same path and signal have the same key. *)
let key (w : wanted) =
  let step : Catalogue.step -> string = function
    | Instance k -> "i" ^ string_of_int k
    | Mode k -> "m" ^ string_of_int k
  in
  let own = match w.own with Signal id -> string_of_int id | Running_mode -> "mode" in
  String.concat " " (own :: List.map step w.path)

(* A signal that a node can return as an additional output. *)
type given = { wanted : wanted; atom : Ir.atom; ty : Ir.ty }

let by_key (given : given list) =
  let table = String_table.create 16 in
  List.iter (fun (g : given) -> String_table.replace table (key g.wanted) g) given;
  table

type t = {
  before : Ir.program;
  nodes : Ir.node array;
  mutable sums : Ir.sum list;  (** all sums, in reverse order *)
  mutable next_id : int;
  wanted : wanted list array;  (** the requested signals of each node *)
  asked : unit String_table.t array;  (** the keys of [wanted] *)
  given : given list array;
  found : given String_table.t array;  (** the entries of [given], by key *)
}

let fresh t ~name ~span ty : Ir.signal =
  let id = t.next_id in
  t.next_id <- id + 1;
  { id; name; ty; group = id; span }

let sum t k = List.nth t.sums (List.length t.sums - 1 - k)

let add_sum t (sum : Ir.sum) : Ir.ty =
  let rec find k = function
    | [] ->
        t.sums <- sum :: t.sums;
        Ir.Sum (List.length t.sums - 1)
    | (other : Ir.sum) :: _ when other = sum -> Sum k
    | _ :: rest -> find (k - 1) rest
  in
  find (List.length t.sums - 1) t.sums

(* {1 Values that may be absent} *)

let rec shape (ty : Ir.ty) : Ir.shape =
  match ty with Array (n, element) -> Repeated (n, shape element) | ty -> Leaf ty

let rec type_name t (ty : Ir.ty) =
  match ty with
  | Bool -> "Bool"
  | Int -> "Int"
  | Float -> "Float"
  | Sum k ->
      let ({ name; _ } : Ir.sum) = sum t k in
      if String.contains name ' ' then "(" ^ name ^ ")" else name
  | Array (n, element) -> Printf.sprintf "(Array %d %s)" n (type_name t element)
  | Foreign f -> f.foreign_name

let rec is_event t (ty : Ir.ty) =
  match ty with
  | Sum k -> (
      match sum t k with
      | { module_ = "Prelude"; constructors = [ { constructor = "NoEvent"; _ }; _ ]; _ } -> true
      | _ -> false)
  | Array (_, element) -> is_event t element
  | Bool | Int | Float | Foreign _ -> false

let event_of t ty =
  if is_event t ty then ty
  else
    let constructor constructor fields : Ir.sum_constructor = { constructor; fields } in
    let constructors = [ constructor "NoEvent" []; constructor "Event" [ ("", shape ty) ] ] in
    add_sum t { name = "Event " ^ type_name t ty; module_ = "Prelude"; constructors }

(* Adds an equation to the end of the list [equations]. *)
let define t equations ~name ~span ty rhs =
  let signal = fresh t ~name ~span ty in
  equations := { Ir.defines = signal; rhs; span } :: !equations;
  Ir.Signal signal

let rec absent t equations ~span (ty : Ir.ty) =
  match ty with
  | Array (_, element) ->
      define t equations ~name:"" ~span ty (Fill (absent t equations ~span element))
  | ty -> define t equations ~name:"" ~span ty (Construct { constructor = 0; payload = [] })

let present t equations ~span (g : given) =
  if is_event t g.ty then g.atom
  else
    let ty = event_of t g.ty in
    define t equations ~name:g.wanted.label ~span ty
      (Construct { constructor = 1; payload = [ g.atom ] })

(* {1 The signals requested from each node} *)

let inner_wanted (node : Ir.node) (w : wanted) =
  match (w.path, node.machine) with
  | [], _ -> None
  | Instance k :: path, _ -> Some ((List.nth node.instances k).node, { w with path })
  | Mode k :: path, Some machine -> Some (List.nth machine.modes k, { w with path })
  | Mode _ :: _, None -> bug "a mode without a machine"

let ask t index w =
  let key = key w in
  if not (String_table.mem t.asked.(index) key) then (
    String_table.replace t.asked.(index) key ();
    t.wanted.(index) <- w :: t.wanted.(index))

let ask_all t probes =
  let root = Array.length t.nodes - 1 in
  List.iter
    (fun (p : Catalogue.probe) -> ask t root { path = p.path; own = own p.own; label = p.signal })
    probes;
  for index = root downto 0 do
    t.wanted.(index) <- List.rev t.wanted.(index);
    List.iter
      (fun w -> Option.iter (fun (inner, w) -> ask t inner w) (inner_wanted t.nodes.(index) w))
      t.wanted.(index)
  done

(* {1 Additional outputs} *)

(* One of the node's own signals. *)
let own_signal (node : Ir.node) id =
  let is_it (s : Ir.signal) = s.id = id in
  match List.find_opt is_it (node.statics @ node.inputs @ Catalogue.defined node) with
  | Some s -> s
  | None -> bug "a node does not have the requested signal"

(* Adds outputs for the requested signals to an instance. *)
let instance t (i : Ir.instance) =
  let output (g : given) =
    let ty = match i.loop with Some { count; _ } -> Ir.Array (count, g.ty) | None -> g.ty in
    { g with atom = Signal (fresh t ~name:g.wanted.label ~span:i.span ty); ty }
  in
  let given = List.map output t.given.(i.node) in
  let signal (g : given) =
    match g.atom with Signal s -> s | Bool _ | Int _ | Float _ -> bug "an output without a signal"
  in
  ({ i with outputs = i.outputs @ List.map signal given }, given)

let with_outputs (node : Ir.node) ~equations others =
  { node with equations = node.equations @ List.rev equations; outputs = node.outputs @ others }

let find (found : given String_table.t) (w : wanted) =
  match String_table.find_opt found (key w) with
  | Some given -> given
  | None -> bug "a node does not return the requested signal"

(* All modes of a machine must have the same outputs. Each mode computes the signals requested from
   it; the signals of the other modes are absent. *)
let machine t index (node : Ir.node) (machine : Ir.machine) equations =
  let span = machine.span in
  let number =
    lazy
      (let constructor name : Ir.sum_constructor = { constructor = name; fields = [] } in
       let names = Catalogue.mode_names t.before machine in
       add_sum t
         { name = "Mode " ^ node.origin; module_ = ""; constructors = List.map constructor names })
  in
  let is_asked w =
    match w.path with Instance _ :: _ -> false | [] -> w.own = Running_mode | Mode _ :: _ -> true
  in
  let asked = List.filter is_asked t.wanted.(index) in
  let always = List.compare_length_with machine.modes 1 = 0 && Option.is_none machine.active in
  let in_mode (w : wanted) =
    match w.path with
    | Mode k :: path -> Some (k, find t.found.(List.nth machine.modes k) { w with path })
    | [] | Instance _ :: _ -> None
  in
  let ty w =
    match in_mode w with
    | Some (_, g) -> if always then g.ty else event_of t g.ty
    | None ->
        if Option.is_none machine.active then Lazy.force number else event_of t (Lazy.force number)
  in
  let tys = List.map ty asked in
  List.iteri
    (fun k mode ->
      let own_equations = ref [] in
      let span = t.nodes.(mode).span in
      let output w ty =
        let atom =
          match in_mode w with
          | Some (n, g) when n = k -> if always then g.atom else present t own_equations ~span g
          | Some _ -> absent t own_equations ~span ty
          | None ->
              let atom =
                define t own_equations ~name:w.label ~span (Lazy.force number)
                  (Construct { constructor = k; payload = [] })
              in
              if Option.is_none machine.active then atom
              else present t own_equations ~span { wanted = w; atom; ty = Lazy.force number }
        in
        (w.label, atom)
      in
      let others = List.map2 output asked tys in
      t.nodes.(mode) <- with_outputs t.nodes.(mode) ~equations:!own_equations others)
    machine.modes;
  let signals = List.map2 (fun w ty -> fresh t ~name:w.label ~span ty) asked tys in
  let seen w (s : Ir.signal) =
    let atom =
      match machine.active with
      | None -> Ir.Signal s
      | Some condition ->
          let else_ = absent t equations ~span s.ty in
          define t equations ~name:w.label ~span s.ty (If { condition; then_ = Signal s; else_ })
    in
    { wanted = w; atom; ty = s.ty }
  in
  ({ machine with outputs = machine.outputs @ signals }, List.map2 seen asked signals)

let extend t ~is_mode index =
  let node = t.nodes.(index) in
  let equations = ref [] in
  let extended = List.map (instance t) node.instances in
  let inside = Array.of_list (List.map (fun (_, given) -> by_key given) extended) in
  let machine = Option.map (fun m -> machine t index node m equations) node.machine in
  let of_machine = Option.map (fun (_, given) -> by_key given) machine in
  let given (w : wanted) =
    match (w.path, w.own) with
    | [], Signal id ->
        let s = own_signal node id in
        { wanted = w; atom = Signal s; ty = s.ty }
    | Instance k :: path, _ ->
        let inner = find inside.(k) { w with path } in
        { inner with wanted = w }
    | [], Running_mode | Mode _ :: _, _ -> (
        match of_machine with Some given -> find given w | None -> bug "a mode without a machine")
  in
  let given = List.map given t.wanted.(index) in
  t.given.(index) <- given;
  t.found.(index) <- by_key given;
  let node = { node with instances = List.map fst extended; machine = Option.map fst machine } in
  let others =
    if is_mode then [] else List.map (fun (g : given) -> (g.wanted.label, g.atom)) given
  in
  t.nodes.(index) <- with_outputs node ~equations:!equations others

let program (before : Ir.program) probes =
  let count = Array.length before.nodes in
  let t =
    {
      before;
      nodes = Array.copy before.nodes;
      sums = List.rev (Array.to_list before.sums);
      next_id = before.next_id;
      wanted = Array.make count [];
      asked = Array.init count (fun _ -> String_table.create 16);
      given = Array.make count [];
      found = Array.init count (fun _ -> String_table.create 1);
    }
  in
  ask_all t probes;
  let is_mode = Array.make count false in
  Array.iter
    (fun (node : Ir.node) ->
      Option.iter
        (fun (m : Ir.machine) -> List.iter (fun mode -> is_mode.(mode) <- true) m.modes)
        node.machine)
    before.nodes;
  Array.iteri (fun index _ -> extend t ~is_mode:is_mode.(index) index) before.nodes;
  let shown (p : Catalogue.probe) (g : given) = (p.name, shape g.ty) in
  {
    before with
    nodes = t.nodes;
    sums = Array.of_list (List.rev t.sums);
    next_id = t.next_id;
    probes = before.probes @ List.map2 shown probes t.given.(count - 1);
  }

let claims ~shown ~margin probes =
  (* The margin columns belong to the same instance as the claim, so their names differ from the
     claim's name only in the last part. *)
  let margin_of (p : Catalogue.probe) =
    let way = String.sub p.name 0 (String.length p.name - String.length p.signal) in
    let column number = way ^ Core.Margin.column p.signal number in
    let json = Option.map (Core.Formula.to_json column) (margin p.span) in
    (* C compilers only need to accept string literals of up to 4095 characters. *)
    Option.bind json (fun json -> if String.length json < 4000 then Some json else None)
  in
  let claim (p : Catalogue.probe) : Ir.claim =
    let label = Option.value (Resolve.Labels.label p.signal) ~default:p.signal in
    {
      column = p.name;
      is_assumption = Resolve.Labels.is_assumption p.signal;
      label;
      shown = shown p;
      claimed_at = p.span;
      margin = margin_of p;
    }
  in
  List.map claim (List.filter Selection.is_claim probes)

let has_claims (program : Ir.program) =
  let defines (e : Ir.equation) = Resolve.Labels.is_name e.defines.name in
  let gives (i : Ir.instance) =
    List.exists (fun (s : Ir.signal) -> Resolve.Labels.is_name s.name) i.outputs
  in
  Array.exists
    (fun (node : Ir.node) ->
      List.exists defines node.equations
      || List.exists gives node.instances
      || List.exists (fun (s : Ir.signal) -> Resolve.Labels.is_name s.name) node.statics)
    program.nodes
