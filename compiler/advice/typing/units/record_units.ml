open Typing

(* Describes how the units of the fields are related. *)
let relation (constructor : Environment.constructor) =
  let field (name, ty) =
    match (ty : Ir.ty) with
    | Number (_, u) -> Some (Printf.sprintf "`%s` has `%s`" name (Show.unit_ u))
    | _ -> None
  in
  Printf.sprintf "in a `%s`, the units depend on each other: %s" constructor.tycon.name
    (String.concat ", " (List.filter_map field constructor.ir.fields))

(* `Pid[m, m/s]` (u is `m`, v is `m/s`). *)
let with_unit_variables words (constructor : Environment.constructor) ty units =
  let variable ({ variable = v; _ } : Units.rigid) u =
    Printf.sprintf "%s is `%s`" v.name (Wording.measure words u)
  in
  Printf.sprintf "`%s` (%s)" (Wording.type_ words ty)
    (String.concat ", " (List.map2 variable constructor.scheme.units units))

let completed words (constructor : Environment.constructor)
    ({ ty; units; is_example; fields } : Expected.completed) =
  let field ((name : Syntax.Ir.name), (number : Expected.number option), unit_) =
    match (number, unit_) with
    | Some { negative; digits; unit_ = written; at }, Some u when not (Units.is_open u) ->
        let measure = Wording.measure words u in
        let is_zero = float_of_string_opt digits = Some 0. in
        let literal =
          if is_zero || String.equal measure "1" then digits
          else Printf.sprintf "%s[%s]" digits measure
        in
        let is_right =
          match Option.bind written (Wording.unit_written words) with
          | Some unit_ -> Units.equal unit_ u
          | None -> String.equal literal digits
        in
        (* keep a correct unit as it is written: `60[deg/s]`, not `60[1/s]` *)
        let literal =
          if is_right then Option.value (Wording.quote words at) ~default:literal else literal
        in
        let edit = if is_right then None else Some (at, literal) in
        Some (Printf.sprintf "%s = %s%s" name.text (if negative then "-" else "") literal, edit)
    | _ -> None
  in
  let written = List.map field fields in
  if List.mem None written || List.exists Units.is_open units then None
  else
    let all = List.filter_map Fun.id written in
    let record =
      Printf.sprintf "%s { %s }" constructor.ir.constructor.name
        (String.concat ", " (List.map fst all))
    in
    let text =
      Printf.sprintf "give all numbers in the record their units: for a %s%s, write `%s`"
        (with_unit_variables words constructor ty units)
        (if is_example then ", for example" else "")
        record
    in
    Some (text, List.filter_map snd all)
