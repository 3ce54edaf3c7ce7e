type kind = Type | Size | Unit | Representation

let letters = function
  | Type -> "abcdefghijkl"
  | Size -> "mpqr"
  | Unit -> "uvwxyz"
  | Representation -> "n"

let nth kind k =
  let letters = letters kind in
  let round = k / String.length letters in
  let letter = String.make 1 letters.[k mod String.length letters] in
  if round = 0 then letter else letter ^ string_of_int round

let type_meant name =
  match String.lowercase_ascii name with
  | ( "float" | "double" | "int" | "integer" | "bool" | "string" | "time" | "distance" | "velocity"
    | "acceleration" | "angle" ) as name ->
      Some (String.capitalize_ascii name)
  | "angularvelocity" -> Some "AngularVelocity"
  | "boolean" -> Some "Bool"
  | "str" -> Some "String"
  | _ -> None
