let representation r : Ir.representation =
  match Type.representation r with
  | Int -> Int
  | Float | Flexible_representation _ -> Float
  | Rigid_representation { variable; _ } -> Representation_variable variable

let rec ty (t : Type.t) : Ir.ty =
  match t with
  | Flexible { final = Some final; _ } -> final
  | Flexible ({ found; _ } as variable) ->
      let final = match found with Some t -> ty t | None -> Ir.Tuple [] in
      variable.final <- Some final;
      final
  | Rigid { variable; _ } -> Variable variable
  | Number (r, u) -> Number (representation r, Units.to_ir u)
  | Bool -> Bool
  | String -> String
  | Tuple elements -> Tuple (List.map ty elements)
  | Function (a, b) ->
      let a = ty a in
      Function (a, ty b)
  | Signal_function (a, b) ->
      let a = ty a in
      Signal_function (a, ty b)
  | Data { tycon; units; arguments } ->
      Data { tycon; units = List.map Units.to_ir units; arguments = List.map ty arguments }
  | Alias { expansion; _ } -> ty expansion
  | Erroneous -> Tuple []

let scheme (s : Type.scheme) : Ir.scheme =
  let variable (r : Units.rigid) = r.variable in
  {
    types = List.map (fun (r : Type.rigid) -> r.variable) s.types;
    representations = List.map variable s.representations;
    units = List.map variable s.units;
    context = List.map (fun (class_, t) -> (class_, ty t)) s.context;
    ty = ty s.body;
  }
