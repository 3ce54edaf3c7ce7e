type t = { module_ : string; name : string; header : string; file : string option }

let robot module_ name = { module_; name; header = "frob/" ^ name ^ ".h"; file = None }
let default = robot "Pioneer" "pioneer"
let all = [ default; robot "Scout" "scout"; robot "Create" "create" ]
let of_name name = List.find_opt (fun robot -> String.equal robot.name name) all

let own file =
  let module_ = Filename.remove_extension (Filename.basename file) in
  let name = Name.snake module_ in
  { module_; name; header = name ^ ".h"; file = Some file }

let is_own robot = Option.is_some robot.file
let included robot = Printf.sprintf (if is_own robot then "\"%s\"" else "<%s>") robot.header
let input robot = robot.module_ ^ "Input"
let output robot = robot.module_ ^ "Output"

let of_shape ?own (shape : Flow.Ir.shape) =
  match shape with
  | Product { product_module; product_name; record = true; _ } ->
      let is_of robot =
        String.equal product_module robot.module_
        && List.mem product_name [ input robot; output robot ]
      in
      List.find_opt is_of (Option.to_list own @ all)
  | Product _ | Leaf _ | Repeated _ -> None

type console = { part : string * Flow.Ir.shape; at : int }

let is_console ((_, shape) : string * Flow.Ir.shape) =
  match shape with
  | Product { product_name; product_module; _ } ->
      Core.Console.has_name ~module_:product_module product_name
  | Leaf _ | Repeated _ -> false

let apart (shape : Flow.Ir.shape) =
  let rec split before parts =
    match parts with
    | part :: after when is_console part -> Some (List.rev before, part, after)
    | part :: after -> split (part :: before) after
    | [] -> None
  in
  match shape with
  | Leaf _ | Repeated _ -> (shape, None)
  | Product product -> (
      match split [] product.parts with
      | None -> (shape, None)
      | Some (before, part, after) ->
          let leaves (_, shape) = List.length (Flow.Shape.leaves shape) in
          let at = List.fold_left (fun sum part -> sum + leaves part) 0 before in
          (Product { product with parts = before @ after }, Some { part; at }))
