open Basis

type t = {
  definitions : Ir.rhs Int_table.t;
  known : (Ir.signal * bool) list;  (** the values that were given *)
  values : bool Int_table.t option;  (** the values derived so far, by signal *)
}

let rec given (s : Ir.signal) = function
  | [] -> None
  | ((known : Ir.signal), b) :: rest -> if known.id = s.id then Some b else given s rest

let find t (s : Ir.signal) =
  match (t.values, t.known) with
  | None, [] -> None
  | None, known -> given s known
  | Some values, known -> (
      match Int_table.find_opt values s.id with Some b -> Some b | None -> given s known)

(* Maximum depth of the search: deeper than people nest conditions, but small enough to be fast. *)
let depth = 6

let rec value ?(depth = depth) t (atom : Ir.atom) =
  let value a = if depth = 0 then None else value ~depth:(depth - 1) t a in
  match atom with
  | Bool b -> Some b
  | Int _ | Float _ -> None
  | Signal s -> (
      match find t s with
      | Some b -> Some b
      | None -> (
          match Int_table.find_opt t.definitions s.id with
          | Some (Copy a) -> value a
          | Some (Op (Not, [ a ])) -> Option.map not (value a)
          | Some (Op (And, [ a; b ])) -> (
              match (value a, value b) with
              | Some false, _ | _, Some false -> Some false
              | Some true, Some true -> Some true
              | None, _ | _, None -> None)
          | Some (Op (Or, [ a; b ])) -> (
              match (value a, value b) with
              | Some true, _ | _, Some true -> Some true
              | Some false, Some false -> Some false
              | None, _ | _, None -> None)
          | Some (If { condition; then_; else_ }) -> (
              match (value condition, value then_, value else_) with
              | Some true, v, _ | Some false, _, v -> v
              | None, v, v' -> if v = v' then v else None)
          | Some _ | None -> None))

(* Records the value of an atom, and derives values of its operands. *)
let rec learn ?(depth = depth) t (atom : Ir.atom) b =
  let learn a b = if depth > 0 then learn ~depth:(depth - 1) t a b in
  match atom with
  | Bool _ | Int _ | Float _ -> ()
  | Signal s -> (
      Option.iter (fun values -> Int_table.replace values s.id b) t.values;
      match (Int_table.find_opt t.definitions s.id, b) with
      | Some (Copy a), _ -> learn a b
      | Some (Op (Not, [ a ])), _ -> learn a (not b)
      | Some (Op (And, [ x; y ])), true | Some (Op (Or, [ x; y ])), false ->
          learn x b;
          learn y b
      | Some (Op (And, [ x; y ])), false | Some (Op (Or, [ x; y ])), true -> (
          let other = not b in
          match (value t x, value t y) with
          | Some v, None when Bool.equal v other -> learn y b
          | None, Some v when Bool.equal v other -> learn x b
          | _, _ -> ())
      | _, _ -> ())

let definitions (node : Ir.node) =
  let definitions = Int_table.create 64 in
  List.iter
    (fun (e : Ir.equation) ->
      if e.defines.ty = Bool then Int_table.replace definitions e.defines.id e.rhs)
    node.equations;
  definitions

let at_an_instant (node : Ir.node) =
  let definitions = definitions node in
  fun known -> { definitions; known; values = None }

let while_running (node : Ir.node) =
  let at_an_instant = at_an_instant node in
  fun known ->
    let t = { (at_an_instant known) with values = Some (Int_table.create 16) } in
    List.iter (fun (next : Ir.transition) -> learn t next.occurs false) node.transitions;
    t

let at_first_instant (node : Ir.node) =
  let all = Int_table.create 64 in
  List.iter (fun (e : Ir.equation) -> Int_table.replace all e.defines.id e.rhs) node.equations;
  let definition : Ir.atom -> Ir.rhs option = function
    | Signal s -> Int_table.find_opt all s.id
    | Bool _ | Int _ | Float _ -> None
  in
  let is_time atom = match definition atom with Some (Time _) -> true | Some _ | None -> false in
  let values = Int_table.create 16 in
  let learn (e : Ir.equation) =
    let learn b = Int_table.replace values e.defines.id b in
    match e.rhs with
    | Delay { init = Bool b; _ } -> learn b
    | Ticks (Float period) when period >= 1. -> learn false
    | Op (Less_equal, [ Float least; ns ]) when least > 0. -> (
        match definition ns with
        | Some (Op (Elementary Nanoseconds, [ time ])) when is_time time -> learn false
        | Some _ | None -> ())
    | _ -> ()
  in
  List.iter learn node.equations;
  { definitions = definitions node; known = []; values = Some values }

let value t atom = value t atom
