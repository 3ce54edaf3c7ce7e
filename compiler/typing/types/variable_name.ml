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
  match String.capitalize_ascii name with
  | ( "Float" | "Double" | "Int" | "Integer" | "Bool" | "String" | "Time" | "Distance" | "Velocity"
    | "Acceleration" | "Angle" ) as type_ ->
      Some type_
  | _ -> None
