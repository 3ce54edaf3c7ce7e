type t = { types : Type.rigid list; representations : Units.rigid list; units : Units.rigid list }

(* Number of variables created so far, by kind. *)
type counts = { of_types : int; of_sizes : int; of_representations : int; of_units : int }

type state = {
  supply : Type.supply;
  depth : int;
  mutable found : t;  (** newest first *)
  mutable counts : counts;
}

(* The maximum number of parts in a type also limits the number of variables in a scheme, because
   larger schemes would slow down later stages. *)
let variable state kind count : Ir.variable =
  if count > Final.most_parts then raise_notrace Final.Too_large;
  { id = Type.next state.supply; name = Variable_name.nth kind count }

let new_type state kind : Type.rigid =
  let { of_types; of_sizes; _ } = state.counts in
  let variable =
    match (kind : Type.kind) with
    | Of_types ->
        state.counts <- { state.counts with of_types = of_types + 1 };
        variable state Type of_types
    | Of_sizes ->
        state.counts <- { state.counts with of_sizes = of_sizes + 1 };
        variable state Size of_sizes
  in
  let rigid : Type.rigid = { variable; kind; depth = state.depth } in
  state.found <- { state.found with types = rigid :: state.found.types };
  rigid

let new_representation state : Units.rigid =
  let k = state.counts.of_representations in
  let rigid : Units.rigid = { variable = variable state Representation k; depth = state.depth } in
  state.counts <- { state.counts with of_representations = k + 1 };
  state.found <- { state.found with representations = rigid :: state.found.representations };
  rigid

let new_unit state () : Units.rigid =
  let k = state.counts.of_units in
  let rigid : Units.rigid = { variable = variable state Unit k; depth = state.depth } in
  state.counts <- { state.counts with of_units = k + 1 };
  state.found <- { state.found with units = rigid :: state.found.units };
  rigid

let unit_ state u = ignore (Units.generalize ~fresh:(new_unit state) u)

let representation state r =
  match Type.representation r with
  | Type.Flexible_representation variable ->
      variable.found <- Some (Rigid_representation (new_representation state))
  | Int | Float | Rigid_representation _ -> ()

let rec ty state t =
  Basis.Work.step ();
  match Type.repr t with
  | Flexible variable -> variable.found <- Some (Rigid (new_type state variable.kind))
  | Number (r, u) ->
      representation state r;
      unit_ state u
  | Tuple elements -> List.iter (ty state) elements
  | Function (a, b) | Signal_function (a, b) ->
      ty state a;
      ty state b
  | Data { units; arguments; _ } ->
      List.iter (unit_ state) units;
      List.iter (ty state) arguments
  | Alias { units; arguments; expansion; _ } ->
      if units <> [] || arguments <> [] then ty state expansion
  | Rigid _ | Bool | String | Size _ | Erroneous -> ()

let none = { types = []; representations = []; units = [] }

let types supply ~depth ts =
  let counts = { of_types = 0; of_sizes = 0; of_representations = 0; of_units = 0 } in
  let state = { supply; depth; found = none; counts } in
  List.iter (ty state) ts;
  {
    types = List.rev state.found.types;
    representations = List.rev state.found.representations;
    units = List.rev state.found.units;
  }
