exception Too_large

let most_parts = 20_000
let deepest = 500

let representation r : Ir.representation =
  match Type.representation r with
  | Int -> Int
  | Float | Flexible_representation _ -> Float
  | Rigid_representation { variable; _ } -> Representation_variable variable

let leaf ty : Type.final = { ty; parts = 1; nesting = 0 }
let unit_type = leaf (Ir.Tuple [])
let without_unit : Ir.unit_ = { base = []; variables = [] }
let plain_float = leaf (Ir.Number (Float, without_unit))
let plain_int = leaf (Ir.Number (Int, without_unit))

(* Common types are allocated once and shared. *)
let number (r : Ir.representation) (u : Ir.unit_) =
  match (r, u) with
  | Float, { base = []; variables = [] } -> plain_float
  | Int, { base = []; variables = [] } -> plain_int
  | (Float | Int | Representation_variable _), _ -> leaf (Number (r, u))

let limited (final : Type.final) =
  if final.parts > most_parts || final.nesting > deepest then raise Too_large;
  final

let compound ty (inside : Type.final list) =
  let parts = List.fold_left (fun n (f : Type.final) -> n + f.parts) 1 inside in
  let nesting = List.fold_left (fun n (f : Type.final) -> Int.max n f.nesting) 0 inside in
  limited { ty; parts; nesting = nesting + 1 }

let types = List.map (fun (f : Type.final) -> f.ty)

let rec final (t : Type.t) : Type.final =
  match t with
  | Flexible { final = Some known; _ } -> known
  | Flexible ({ found; _ } as variable) ->
      let known =
        match (found, variable.kind) with
        | Some t, _ -> final t
        | None, Of_types -> unit_type
        | None, Of_sizes -> leaf (Size 1)
      in
      variable.final <- Some known;
      known
  | Rigid { variable; _ } -> leaf (Variable variable)
  | Number (r, u) -> number (representation r) (Units.to_ir u)
  | Bool -> leaf Bool
  | String -> leaf String
  | Size n -> leaf (Size n)
  | Tuple elements ->
      let elements = List.map final elements in
      compound (Tuple (types elements)) elements
  | Function (a, b) ->
      (* Curried arguments do not add to the nesting depth. *)
      let a = final a in
      let b = final b in
      let nesting = Int.max (a.nesting + 1) b.nesting in
      limited { ty = Function (a.ty, b.ty); parts = 1 + a.parts + b.parts; nesting }
  | Signal_function (a, b) ->
      let a = final a in
      let b = final b in
      compound (Signal_function (a.ty, b.ty)) [ a; b ]
  | Data { tycon; units; arguments = [] } ->
      leaf (Data { tycon; units = List.map Units.to_ir units; arguments = [] })
  | Data { tycon; units; arguments } ->
      let arguments = List.map final arguments in
      compound
        (Data { tycon; units = List.map Units.to_ir units; arguments = types arguments })
        arguments
  | Alias { expansion; _ } -> final expansion
  | Erroneous -> unit_type

let ty t = (final t).ty

let scheme (s : Type.scheme) : Ir.scheme =
  let variable (r : Units.rigid) = r.variable in
  {
    types = List.map (fun (r : Type.rigid) -> r.variable) s.types;
    representations = List.map variable s.representations;
    units = List.map variable s.units;
    context = List.map (fun (class_, t) -> (class_, ty t)) s.context;
    ty = ty s.body;
  }
