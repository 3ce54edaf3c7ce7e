type t = { module_ : string; name : string; header : string }

let robot module_ name = { module_; name; header = "frob/" ^ name ^ ".h" }
let default = robot "Pioneer" "pioneer"
let all = [ default; robot "Scout" "scout"; robot "Create" "create" ]
let of_name name = List.find_opt (fun robot -> String.equal robot.name name) all

let input robot = robot.module_ ^ "Input"
let output robot = robot.module_ ^ "Output"

let of_shape (shape : Flow.Ir.shape) =
  match shape with
  | Product { product_module; product_name; record = true; _ } ->
      let is_of robot =
        String.equal product_module robot.module_
        && List.mem product_name [ input robot; output robot ]
      in
      List.find_opt is_of all
  | Product _ | Leaf _ | Repeated _ -> None
