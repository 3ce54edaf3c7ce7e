type t =
  | Flexible of flexible
  | Rigid of rigid
  | Number of representation * Units.t
  | Bool
  | String
  | Tuple of t list
  | Function of t * t
  | Signal_function of t * t
  | Data of { tycon : Ir.Global.t; units : Units.t list; arguments : t list }
  | Alias of { alias : Ir.Global.t; units : Units.t list; arguments : t list; expansion : t }
  | Size of int
  | Erroneous

and flexible = {
  id : int;
  kind : kind;
  mutable depth : int;
  mutable found : t option;
  mutable final : final option;
}

and final = { ty : Ir.ty; parts : int; nesting : int }
and rigid = { variable : Ir.variable; kind : kind; depth : int }
and kind = Of_types | Of_sizes

and representation =
  | Int
  | Float
  | Flexible_representation of flexible_representation
  | Rigid_representation of Units.rigid

and flexible_representation = {
  id : int;
  mutable depth : int;
  mutable found : representation option;
}

type scheme = {
  types : rigid list;
  representations : Units.rigid list;
  units : Units.rigid list;
  context : (Ir.class_ * t) list;
  body : t;
}

let monomorphic body = { types = []; representations = []; units = []; context = []; body }

type supply = { mutable last : int }

let supply () = { last = 0 }

let next supply =
  supply.last <- supply.last + 1;
  supply.last

let fresh supply ?(kind = Of_types) ~depth () =
  Flexible { id = next supply; kind; depth; found = None; final = None }

let fresh_representation supply ~depth =
  Flexible_representation { id = next supply; depth; found = None }

let fresh_unit supply ~depth = Units.fresh ~id:(next supply) ~depth

let fresh_number supply ~depth =
  Number (fresh_representation supply ~depth, fresh_unit supply ~depth)

let rec repr = function
  | Flexible ({ found = Some t; _ } as variable) -> (
      match t with
      | Flexible _ ->
          let t = repr t in
          variable.found <- Some t;
          t
      | t -> t)
  | t -> t

let rec expand t = match repr t with Alias { expansion; _ } -> expand expansion | t -> t

let rec kind t =
  match repr t with
  | Flexible { kind; _ } | Rigid { kind; _ } -> kind
  | Size _ -> Of_sizes
  | Alias { expansion; _ } -> kind expansion
  | Number _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Data _ | Erroneous ->
      Of_types

let rec representation = function
  | Flexible_representation ({ found = Some r; _ } as variable) -> (
      match r with
      | Flexible_representation _ ->
          let r = representation r in
          variable.found <- Some r;
          r
      | r -> r)
  | r -> r

let shared t = Flexible { id = 0; kind = Of_types; depth = 0; found = Some t; final = None }

module Ids = Map.Make (Int)

type substitution = {
  by_type : t Ids.t;
  by_representation : representation Ids.t;
  by_unit : Units.t Ids.t;
}

let substitute_unit s unit_ = Units.substitute (fun id -> Ids.find_opt id s.by_unit) unit_

let rec apply s t =
  Basis.Work.step ();
  match repr t with
  | Rigid { variable; _ } as t -> (
      match Ids.find_opt variable.id s.by_type with Some by -> by | None -> t)
  | Number (r, unit_) ->
      let r =
        match representation r with
        | Rigid_representation { variable; _ } as r ->
            Option.value (Ids.find_opt variable.id s.by_representation) ~default:r
        | r -> r
      in
      Number (r, substitute_unit s unit_)
  | Tuple elements -> Tuple (List.map (apply s) elements)
  | Function (a, b) ->
      let a = apply s a in
      Function (a, apply s b)
  | Signal_function (a, b) ->
      let a = apply s a in
      Signal_function (a, apply s b)
  | Data { tycon; units; arguments } ->
      Data
        {
          tycon;
          units = List.map (substitute_unit s) units;
          arguments = List.map (apply s) arguments;
        }
  | Alias { alias; units = []; arguments = []; expansion } ->
      Alias { alias; units = []; arguments = []; expansion }
  | Alias { alias; units; arguments; expansion } ->
      Alias
        {
          alias;
          units = List.map (substitute_unit s) units;
          arguments = List.map (apply s) arguments;
          expansion = apply s expansion;
        }
  | (Flexible _ | Bool | String | Size _ | Erroneous) as t -> t

let rec mentions (v : Ir.variable) t =
  Basis.Work.step ();
  match repr t with
  | Rigid { variable; _ } -> variable.id = v.id
  | Tuple elements | Data { arguments = elements; _ } -> List.exists (mentions v) elements
  | Function (a, b) | Signal_function (a, b) -> mentions v a || mentions v b
  | Alias { arguments; expansion; _ } -> arguments <> [] && mentions v expansion
  | Flexible _ | Number _ | Bool | String | Size _ | Erroneous -> false

let by_id id pairs =
  List.fold_left (fun map (variable, by) -> Ids.add (id variable) by map) Ids.empty pairs

let substitute ~types ~units t =
  apply
    {
      by_type = by_id (fun (r : rigid) -> r.variable.id) types;
      by_representation = Ids.empty;
      by_unit = by_id (fun (r : Units.rigid) -> r.variable.id) units;
    }
    t

type instance = {
  ty : t;
  type_arguments : t list;
  representation_arguments : representation list;
  required : (Ir.class_ * t) list;
}

let instantiate supply ~depth scheme =
  match scheme with
  | { types = []; representations = []; units = []; context = []; body } ->
      { ty = body; type_arguments = []; representation_arguments = []; required = [] }
  | _ ->
      let new_for make variables = List.map (fun v -> (v, make supply ~depth)) variables in
      let types =
        List.map (fun (r : rigid) -> (r, fresh supply ~kind:r.kind ~depth ())) scheme.types
      in
      let representations = new_for fresh_representation scheme.representations in
      let units = new_for fresh_unit scheme.units in
      let unit_id (r : Units.rigid) = r.variable.id in
      let s =
        {
          by_type = by_id (fun (r : rigid) -> r.variable.id) types;
          by_representation = by_id unit_id representations;
          by_unit = by_id unit_id units;
        }
      in
      {
        ty = apply s scheme.body;
        type_arguments = List.map snd types;
        representation_arguments = List.map snd representations;
        required = List.map (fun (class_, t) -> (class_, apply s t)) scheme.context;
      }
