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
