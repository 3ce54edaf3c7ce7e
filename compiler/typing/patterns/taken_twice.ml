let rec always_matches (p : Resolve.Ir.pattern) =
  match p.desc with
  | Any | Bound _ -> true
  | As (_, p) -> always_matches p
  | Tuple_of ps | Array_of ps -> List.for_all always_matches ps
  | Constructed _ | Literal _ -> false

(* The constructor, if the branch covers all its values. *)
let takes (b : Resolve.Ir.branch) =
  match (b.pattern.desc, b.right.guards) with
  | Constructed (c, parts), [ { condition = None; _ } ] when List.for_all always_matches parts ->
      Some c
  | _ -> None

let missing (ctx : Context.t) ty (branches : Resolve.Ir.branch list) =
  let is_matched (c : Ir.constructor) =
    List.exists
      (fun (b : Resolve.Ir.branch) ->
        match b.pattern.desc with
        | Constructed (c', _) -> c' = c.constructor
        | Any | Bound _ | As _ | Tuple_of _ | Array_of _ | Literal _ -> false)
      branches
  in
  match Type.expand ty with
  | Data { tycon; _ } -> (
      match (Environment.type_ ctx.reader.environment tycon).definition with
      | Data { constructors; _ } ->
          List.filter (fun c -> not (is_matched c)) constructors
          |> List.map (fun (c : Ir.constructor) -> c.constructor.name)
      | Alias _ | Builtin | Foreign -> [])
  | _ -> []

let tell (ctx : Context.t) ~before ~held ~taken (b : Resolve.Ir.branch) ty branches =
  let explain constructor first =
    match (List.rev held, missing ctx ty branches) with
    | _ :: others, missing :: _ ->
        Context.pass_on ctx (List.rev others);
        let fact : Inference_fact.t =
          Matched_twice { constructor; first; second = b.pattern; missing }
        in
        Context.replace ctx (Inference { around = Context.surroundings ctx; fact })
    | _ -> Context.pass_on ctx held
  in
  match takes b with
  | None -> Context.pass_on ctx held
  | Some c -> (
      match List.assoc_opt c !taken with
      | Some first when Context.errors ctx > before -> explain c first
      | Some _ -> Context.pass_on ctx held
      | None ->
          taken := (c, b.pattern) :: !taken;
          Context.pass_on ctx held)
