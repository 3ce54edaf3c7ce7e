open Basis

type t = {
  atoms : Ir.atom Int_table.t;  (** replacement atoms, by the id of the replaced signal *)
  names : Ir.signal Int_table.t;
      (** maps the id of each signal that inherits its name and place to the signal from which it
          inherits them *)
}

let create () = { atoms = Int_table.create 16; names = Int_table.create 8 }
let is_empty t = Int_table.length t.atoms = 0

let rec last t = function
  | Ir.Signal s as atom -> (
      match Int_table.find_opt t.atoms s.id with Some next -> last t next | None -> atom)
  | (Bool _ | Int _ | Float _) as atom -> atom

(* Path compression: makes every signal of a chain point to its end. *)
let rec shorten t goal = function
  | Ir.Signal s -> (
      match Int_table.find_opt t.atoms s.id with
      | Some next ->
          Int_table.replace t.atoms s.id goal;
          shorten t goal next
      | None -> ())
  | Bool _ | Int _ | Float _ -> ()

let renamed t (s : Ir.signal) =
  match Int_table.find_opt t.names s.id with
  | Some named -> { s with name = named.name; span = named.span }
  | None -> s

let renamed_atom t (a : Ir.atom) : Ir.atom =
  match a with
  | Signal s ->
      let named = renamed t s in
      if named == s then a else Signal named
  | Bool _ | Int _ | Float _ -> a

let atom t a =
  let goal = last t a in
  if goal != a then shorten t goal a;
  renamed_atom t goal

let replace t (s : Ir.signal) by =
  let goal = last t by in
  Int_table.replace t.atoms s.id goal;
  match goal with
  | Signal target ->
      let name = (renamed t s).name in
      if name <> "" && (renamed t target).name = "" then
        Int_table.replace t.names target.id (renamed t s)
  | Bool _ | Int _ | Float _ -> ()

let apply t (node : Ir.node) =
  let equation (e : Ir.equation) =
    if Int_table.mem t.atoms e.defines.id then None
    else
      let defines = renamed t e.defines and rhs = Operands.map (atom t) e.rhs in
      Some (if defines == e.defines && rhs == e.rhs then e else { e with defines; rhs })
  in
  let instance = Operands.of_instance (atom t) (renamed t) in
  {
    node with
    statics = Long_list.map (renamed t) node.statics;
    inputs = Long_list.map (renamed t) node.inputs;
    outputs = Long_list.map (fun (name, a) -> (name, atom t a)) node.outputs;
    equations = List.filter_map equation node.equations;
    instances = Long_list.map instance node.instances;
    machine = Option.map (Transitions.map_machine (atom t) (renamed t)) node.machine;
    transitions = Transitions.map (atom t) node.transitions;
  }

let node t node = if is_empty t then node else apply t node
