(* How a vector is built, perhaps of these. *)
let vector words ?(elements = []) wanted =
  let built name fields =
    let value i field =
      let element = List.nth_opt elements i in
      let text = Option.bind element (fun (e : Resolve.Ir.expr) -> Show.quote words e.span) in
      Printf.sprintf "%s = %s" field (Option.value text ~default:"…")
    in
    Some
      (Printf.sprintf "`%s { %s }`, with `import Geometry`" name
         (String.concat ", " (List.mapi value fields)))
  in
  match wanted with
  | Type.Data { tycon = { name = "Vec2"; _ }; _ } -> built "Vec2" [ "x"; "y" ]
  | Type.Data { tycon = { name = "Vec3"; _ }; _ } -> built "Vec3" [ "x"; "y"; "z" ]
  | _ -> None

(* Of a place, written as a pair. *)
let vector_fields words ~subject wanted types =
  let elements =
    match subject with Some ({ desc = Tuple es; _ } : Resolve.Ir.expr) -> es | _ -> []
  in
  match (wanted, List.length types) with
  | Type.Data { tycon = { name = "Vec2"; _ }; _ }, 2
  | Type.Data { tycon = { name = "Vec3"; _ }; _ }, 3 ->
      vector words ~elements wanted
  | _ -> None

let vector_operator (expected : Expected.t) =
  match expected.because with
  | Parameter { callee = Some operator; _ } | Operand { operator; _ } -> (
      match operator with
      | "+" -> Some "`^+^`"
      | "-" -> Some "`^-^`"
      | "*" -> Some "`*^` with the number first, and `dot`"
      | _ -> None)
  | _ -> None
