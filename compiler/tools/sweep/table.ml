type fate = { held : bool; void : bool }

let truths =
  [
    "x";
    "y";
    "heading";
    "clearance";
    "touches";
    "driven";
    "odometry_error";
    "collisions";
    "collision_at";
    "collision_x";
    "collision_y";
    "collision_clearance";
    "collision_with";
  ]

let quoted cell =
  if String.exists (fun c -> c = ',' || c = '"' || c = '\n') cell then
    "\"" ^ String.concat "\"\"" (String.split_on_char '"' cell) ^ "\""
  else cell

(* The cells of a run are its seed, its outcome with time and cause, the robot's true state and the
   first collision, and the measurements. *)
let fate = function
  | _ :: fate :: _ -> { held = fate = "held" || fate = "unasked"; void = fate = "void" }
  | _ -> { held = false; void = true }

let cell_of cells (m : Measures.t) =
  let prefix = m.probe ^ "=" in
  let n = String.length prefix in
  let value cell =
    if String.starts_with ~prefix cell then Some (String.sub cell n (String.length cell - n))
    else None
  in
  Option.value (List.find_map value cells) ~default:""

let measured _ cells m = Option.value (float_of_string_opt (cell_of cells m)) ~default:Float.nan

let header (t : Setup.t) =
  let names = List.map (fun (axis : Points.axis) -> axis.name) t.axes in
  let measures = List.map (fun (m : Measures.t) -> m.name) t.measures in
  [ "run"; "world"; "robot" ] @ names @ [ "seed"; "fate"; "at"; "by" ] @ truths @ measures

let row (t : Setup.t) rows number =
  let { Runs.place; point; key; _ } = Runs.run t number in
  let cells = Option.value (Rows.find rows key) ~default:[] in
  let own = List.filteri (fun k _ -> k < 4 + List.length truths) cells in
  [ string_of_int (number + 1); place.world; place.robot ]
  @ Array.to_list point @ own
  @ List.map (cell_of cells) t.measures

let csv t rows =
  let text = Buffer.create 65536 in
  let add row =
    Buffer.add_string text (String.concat "," (List.map quoted row));
    Buffer.add_char text '\n'
  in
  add (header t);
  for number = 0 to Runs.count t - 1 do
    add (row t rows number)
  done;
  Buffer.contents text
