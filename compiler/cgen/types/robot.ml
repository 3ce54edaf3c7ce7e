type step = { quantity : string; size : float; unit_ : string }

type t = {
  module_ : string;
  name : string;
  header : string;
  file : string option;
  steps : step list;
}

let robot module_ name steps = { module_; name; header = "frob/" ^ name ^ ".h"; file = None; steps }

(* The resolution of a protocol that sends wheel speeds. If the speed of one wheel changes by one
   step, the turn rate changes, too. *)
let wheels mm_s ~separation_mm =
  let turning = mm_s /. separation_mm *. 180. /. Float.pi in
  [
    { quantity = "each wheel"; size = mm_s; unit_ = "mm/s" };
    { quantity = "resulting turn rate"; size = turning; unit_ = "deg/s" };
  ]

(* These numbers must match those that the driver and the simulator use (runtime/drivers/ROBOT);
   tests/robots/line/steps.t compares them. *)
let default =
  robot "Pioneer" "pioneer"
    [
      { quantity = "ahead"; size = 1.; unit_ = "mm/s" };
      { quantity = "turning"; size = 1.; unit_ = "deg/s" };
    ]

let all =
  [
    default;
    robot "Scout" "scout" (wheels 2.54 ~separation_mm:345.2);
    robot "Create" "create" (wheels 1. ~separation_mm:235.);
    (* ROS messages contain doubles, so there is no fixed resolution. *)
    robot "Ros" "ros" [];
  ]

let of_name name = List.find_opt (fun robot -> String.equal robot.name name) all

let own file =
  let module_ = Filename.remove_extension (Filename.basename file) in
  let name = Name.snake module_ in
  { module_; name; header = name ^ ".h"; file = Some file; steps = [] }

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
