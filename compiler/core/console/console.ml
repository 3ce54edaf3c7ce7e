open Basis
open Ir

let rec asks_itself (e : expr) =
  match e.desc with Primitive (Console _, _) -> true | _ -> List.exists asks_itself (Term.parts e)

let asks program = List.exists (fun (d : definition) -> asks_itself d.body) program.definitions
let has_name ~module_ name = String.equal name "Console" && String.equal module_ "Capability"
let is_console (tycon : Global.t) = has_name ~module_:tycon.module_ tycon.name

let type_of = function
  | Button -> Signature.event (Tuple [])
  | Hold | Toggle _ -> Bool
  | Knob _ -> Float
  | Map -> Signature.event (Tuple [ Float; Float ])
  | Camera -> Signature.event Signature.frame
  | Tags -> Signature.event Signature.tag_frame
  | Lidar { rays } -> Signature.event (Signature.scan (Size rays))
  | Imu -> Signature.event Signature.imu

let declare controls program =
  let fields = List.map (fun c -> (c.label, type_of c.kind)) controls in
  let constructor (c : constructor) = { c with record = true; fields } in
  let data (d : data) =
    if is_console d.tycon then { d with constructors = List.map constructor d.constructors } else d
  in
  let own = List.map data program.data in
  let data =
    let needs_types c =
      match c.kind with
      | Camera | Tags | Lidar _ | Imu -> true
      | Button | Hold | Knob _ | Toggle _ | Map -> false
    in
    if not (List.exists needs_types controls) then own
    else
      (* The types used in the console's fields must be declared before the console. *)
      let is_seen (d : data) =
        List.mem d.tycon.module_ [ "Prelude"; "Geometry"; "Vision"; "Tags"; "Lidar"; "Imu" ]
      in
      let seen, others = List.partition is_seen own in
      seen @ others
  in
  { program with data; console = controls }

let field controls label =
  let rec find k = function
    | [] -> Diagnostic.bug ~stage:"Core.Console" "there is no `%s` on the console" label
    | c :: others -> if String.equal c.label label then k else find (k + 1) others
  in
  find 0 controls

type rest = No_event | Off of bool | At of float

let at_rest = function
  | Button | Map | Camera | Tags | Lidar _ | Imu -> No_event
  | Hold -> Off false
  | Toggle { first } -> Off first
  | Knob { first; _ } -> At first

let map_label = "map"
let tags_ending = " tags"
let tags_label camera = camera ^ tags_ending
let lidar_label lidar rays = Printf.sprintf "%s %d" lidar rays

let camera c =
  match c.kind with
  | Camera -> Some c.label
  | Tags -> Some (String.sub c.label 0 (String.length c.label - String.length tags_ending))
  | Button | Hold | Knob _ | Toggle _ | Map | Lidar _ | Imu -> None

let simulated c =
  match c.kind with
  | Lidar { rays } ->
      let ending = String.length (lidar_label "" rays) in
      Some (Printf.sprintf "the lidar `%s`" (String.sub c.label 0 (String.length c.label - ending)))
  | Imu -> Some (Printf.sprintf "the inertial measurement unit `%s`" c.label)
  | Button | Hold | Knob _ | Toggle _ | Map | Camera | Tags -> None

let describe = function
  | Button -> "a button"
  | Hold -> "a button to hold down"
  | Toggle { first } -> Printf.sprintf "a toggle, initially %s" (if first then "on" else "off")
  | Map -> "clicks on the map"
  | Camera -> "a camera"
  | Tags -> "the tags that a camera sees"
  | Lidar { rays } -> Printf.sprintf "a lidar with %d directions" rays
  | Imu -> "an inertial measurement unit"
  | Knob { least; most; first } ->
      Printf.sprintf "a knob from %g to %g, initially %g" least most first
