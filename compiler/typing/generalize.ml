type t = {
  types : Type.rigid list;
  representations : Units.rigid list;
  units : Units.rigid list;
}

type state = {
  supply : Type.supply;
  depth : int;
  mutable found : t;  (** newest first *)
  mutable counts : int * int * int;
}

let variable state kind count : Ir.variable =
  { id = Type.next state.supply; name = Variable_name.nth kind count }

let new_type state : Type.rigid =
  let t, r, u = state.counts in
  let rigid : Type.rigid = { variable = variable state Type t; depth = state.depth } in
  state.counts <- (t + 1, r, u);
  state.found <- { state.found with types = rigid :: state.found.types };
  rigid

let new_representation state : Units.rigid =
  let t, r, u = state.counts in
  let rigid : Units.rigid = { variable = variable state Representation r; depth = state.depth } in
  state.counts <- (t, r + 1, u);
  state.found <- { state.found with representations = rigid :: state.found.representations };
  rigid

let new_unit state () : Units.rigid =
  let t, r, u = state.counts in
  let rigid : Units.rigid = { variable = variable state Unit u; depth = state.depth } in
  state.counts <- (t, r, u + 1);
  state.found <- { state.found with units = rigid :: state.found.units };
  rigid

let unit_ state u = ignore (Units.generalize ~fresh:(new_unit state) u)

let representation state r =
  match Type.representation r with
  | Type.Flexible_representation variable ->
      variable.found <- Some (Rigid_representation (new_representation state))
  | Int | Float | Rigid_representation _ -> ()

let rec ty state t =
  match Type.repr t with
  | Flexible variable -> variable.found <- Some (Rigid (new_type state))
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
  | Rigid _ | Bool | String | Erroneous -> ()

let none = { types = []; representations = []; units = [] }

let types supply ~depth ts =
  let state = { supply; depth; found = none; counts = (0, 0, 0) } in
  List.iter (ty state) ts;
  {
    types = List.rev state.found.types;
    representations = List.rev state.found.representations;
    units = List.rev state.found.units;
  }
