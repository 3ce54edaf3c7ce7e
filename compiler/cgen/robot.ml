type t = { module_ : string; name : string; header : string }

let robot module_ name = { module_; name; header = "frob/" ^ name ^ ".h" }
let table = [ robot "Pioneer" "pioneer"; robot "Scout" "scout"; robot "Create" "create" ]
let names = List.map (fun robot -> robot.name) table
let of_name name = List.find_opt (fun robot -> String.equal robot.name name) table
let of_module name = List.find_opt (fun robot -> String.equal robot.module_ name) table

let of_shape (shape : Flow.Ir.shape) =
  match shape with
  | Product { product_module; product_name; record = true; _ } -> (
      match of_module product_module with
      | Some robot when List.mem product_name [ robot.module_ ^ "Input"; robot.module_ ^ "Output" ]
        ->
          Some robot
      | Some _ | None -> None)
  | Product _ | Leaf _ | Repeated _ -> None
