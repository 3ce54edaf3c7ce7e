open Basis

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

let tell (ctx : Context.t) ~before ~taken (b : Resolve.Ir.branch) ty branches =
  (match takes b with
  | Some c when Context.errors ctx > before && List.mem_assoc c !taken -> (
      match missing ctx ty branches with
      | other :: _ ->
          let first : Resolve.Ir.pattern = List.assoc c !taken in
          Diagnostic.error ~code:"E0301" ~at:b.pattern.span
            "`%s` is matched twice, and `%s` is never matched" c.name other
          |> Diagnostic.label ~at:first.span "this branch matches all of them"
          |> Diagnostic.hint
               (Printf.sprintf "if this branch is for the other values, write `%s`" other)
          |> fun d -> Diagnostic.revise_last ctx.reader.sink (fun _ -> d)
      | [] -> ())
  | _ -> ());
  match takes b with
  | Some c when not (List.mem_assoc c !taken) -> taken := (c, b.pattern) :: !taken
  | _ -> ()
