type t =
  | Data of Ir.Global.t
  | Int
  | Float
  | Bool
  | String
  | Tuple of int
  | Function
  | Signal_function

let of_type t =
  match Type.expand t with
  | Flexible _ | Rigid _ | Size _ | Erroneous | Alias _ -> None
  | Number (r, _) -> (
      match Type.representation r with
      | Int -> Some (Int, [])
      | Float | Flexible_representation _ -> Some (Float, [])
      | Rigid_representation _ -> None)
  | Bool -> Some (Bool, [])
  | String -> Some (String, [])
  | Tuple parts -> Some (Tuple (List.length parts), parts)
  | Function (a, b) -> Some (Function, [ a; b ])
  | Signal_function (a, b) -> Some (Signal_function, [ a; b ])
  | Data { tycon; arguments; _ } -> Some (Data tycon, arguments)

(* The unit's variable, if the unit consists of that variable alone. *)
let unit_variable u =
  let u = Units.resolve u in
  match (Units.base_powers u, Units.flexible_powers u, Units.rigid_powers u) with
  | [], [], [ (r, p) ] when Rational.equal p Rational.one -> Some r.variable.id
  | _ -> None

let units t =
  match Type.expand t with
  | Number (_, u) -> [ u ]
  | Data { units; _ } -> units
  | Flexible _ | Rigid _ | Erroneous | Alias _ | Bool | String | Tuple _ | Function _
  | Signal_function _ | Size _ ->
      []

let type_variable t =
  match Type.expand t with
  | Rigid r -> Some r
  | Flexible _ | Erroneous | Alias _ | Number _ | Bool | String | Tuple _ | Function _
  | Signal_function _ | Data _ | Size _ ->
      None

let distinct ids = List.length (List.sort_uniq Int.compare ids) = List.length ids

let parameters t =
  match of_type t with
  | None -> None
  | Some (_, arguments) ->
      let types = List.filter_map type_variable arguments in
      let type_ids = List.map (fun (r : Type.rigid) -> r.variable.id) types in
      let units = units t in
      let unit_ids = List.filter_map unit_variable units in
      if
        List.compare_lengths types arguments = 0
        && List.compare_lengths unit_ids units = 0
        && distinct type_ids && distinct unit_ids
      then Some types
      else None
