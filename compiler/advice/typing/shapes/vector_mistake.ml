open Basis
open Typing
open Shape_fact

(* An expression that builds the vector, from these elements if given. *)
let vector words ?(elements = []) wanted =
  let unit_ =
    match Type.expand wanted with
    | Type.Data { units = [ u ]; _ } when not (Units.is_open u || Units.equal u Units.one) ->
        Printf.sprintf "[%s]" (Wording.measure words u)
    | _ -> ""
  in
  let built name fields =
    let value i field =
      let element = List.nth_opt elements i in
      let text = Option.bind element (fun (e : Resolve.Ir.expr) -> Wording.quote words e.span) in
      let is_bare =
        match Option.bind element (Bare_number.literal words) with
        | Some { unit_ = None; name = None; _ } -> true
        | Some _ | None -> false
      in
      Printf.sprintf "%s = %s%s" field
        (Option.value text ~default:"…")
        (if is_bare then unit_ else "")
    in
    Some
      (Printf.sprintf "`%s { %s }`, with `import Geometry`" name
         (String.concat ", " (List.mapi value fields)))
  in
  match wanted with
  | Type.Data { tycon = { name = "Vec2"; _ }; _ } -> built "Vec2" [ "x"; "y" ]
  | Type.Data { tycon = { name = "Vec3"; _ }; _ } -> built "Vec3" [ "x"; "y"; "z" ]
  | _ -> None

let by_name text = "write a vector with its field names: " ^ text

let of_a_number fact =
  match fact.given with
  | Number _ when is_a_parameter fact ->
      let elements =
        match fact.expected.because with
        | Parameter { given; position; _ } -> List.filteri (fun i _ -> i >= position - 1) given
        | _ -> Option.to_list fact.subject
      in
      Option.map
        (fun text -> hinted fact "%s" (by_name text))
        (vector fact.words ~elements fact.wanted)
  | _ -> None

let of_a_tuple fact =
  let elements =
    match fact.subject with Some ({ desc = Tuple es; _ } : Resolve.Ir.expr) -> es | _ -> []
  in
  match (fact.wanted, fact.given) with
  | Data { tycon = { name = "Vec2"; _ }; _ }, Tuple ([ _; _ ] as types)
  | Data { tycon = { name = "Vec3"; _ }; _ }, Tuple ([ _; _; _ ] as types) ->
      let message text =
        Diagnostic.error ~code:"E0301" ~at:fact.at "expected %s, found a tuple with %d elements"
          (expected_text fact) (List.length types)
        |> Diagnostic.hint "%s" (by_name text)
      in
      Option.map message (vector fact.words ~elements fact.wanted)
  | _ -> None

let operator (expected : Expected.t) =
  match expected.because with
  | Parameter { callee = Some operator; _ } | Operand { operator; _ } -> (
      match operator with
      | "+" -> Some "`^+^`"
      | "-" -> Some "`^-^`"
      | "*" -> Some "`*^` with the number first, or `dot`"
      | _ -> None)
  | _ -> None

let of_an_operator fact =
  match (fact.wanted, fact.given) with
  | Number _, Data { tycon = { name = "Vec2" | "Vec3"; _ }; _ } ->
      Option.map
        (fun operator -> hinted fact "for vectors, use %s" operator)
        (operator fact.expected)
  | _ -> None
