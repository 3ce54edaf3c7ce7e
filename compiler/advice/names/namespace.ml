let noun : Resolve.Interface.namespace -> string = function
  | Values -> "name"
  | Constructors -> "constructor"
  | Types -> "type"
  | Units -> "unit"
  | Classes -> "type class"

let unknown : Resolve.Interface.namespace -> string = function
  | Values -> "E0205"
  | Constructors -> "E0206"
  | Types -> "E0207"
  | Units -> "E0208"
  | Classes -> "E0223"
