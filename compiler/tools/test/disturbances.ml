type t = { table : string; key : string }

(* The tables of a world file that can contain disturbances, each with the keys that set them. *)
let keys =
  [
    ("sonar", [ "noise"; "dropout" ]);
    ("drive", [ "slip" ]);
    ("odometry", [ "distance_error"; "turn_error"; "veer_deg"; "heading_noise_deg" ]);
    ("floor", [ "noise" ]);
    ("ambient", [ "noise" ]);
    ("light", [ "noise" ]);
    ("camera", [ "noise"; "dropout" ]);
    ("lidar", [ "noise"; "dropout" ]);
    ( "imu",
      [
        "gyro_noise_deg";
        "gyro_bias_deg";
        "gyro_drift_deg";
        "gyro_scale_error";
        "acceleration_noise";
        "acceleration_bias";
        "compass_noise_deg";
        "compass_error_deg";
      ] );
    ("magnet", [ "strength" ]);
    ("battery", [ "drain" ]);
    ("outage", [ "lasts" ]);
  ]

let name t = Printf.sprintf "[%s] %s" t.table t.key

(* The table whose header is on this line. *)
let table_of line =
  let line = String.trim line in
  if not (String.starts_with ~prefix:"[" line) then None
  else
    let is_bracket c = c = '[' || c = ']' || c = ' ' in
    let upto = match String.index_opt line '#' with Some k -> k | None -> String.length line in
    let letters = List.of_seq (String.to_seq (String.sub line 0 upto)) in
    Some (String.of_seq (List.to_seq (List.filter (fun c -> not (is_bracket c)) letters)))

let setting_of line =
  match String.index_opt line '=' with
  | None -> None
  | Some at ->
      let value = String.sub line (at + 1) (String.length line - at - 1) in
      let value = List.hd (String.split_on_char '#' value) in
      Option.map
        (fun x -> (String.trim (String.sub line 0 at), x))
        (float_of_string_opt (String.trim value))

let is_one table key =
  match List.assoc_opt table keys with Some keys -> List.mem key keys | None -> false

(* Each line, with the disturbance that it sets, if any. *)
let lines text =
  let table = ref "" in
  let line text =
    Option.iter (fun name -> table := name) (table_of text);
    match setting_of text with
    | Some (key, x) when x <> 0. && is_one !table key -> (text, Some { table = !table; key })
    | Some _ | None -> (text, None)
  in
  List.map line (String.split_on_char '\n' text)

let names_files text =
  let is_file line =
    match String.index_opt line '=' with
    | Some at -> String.trim (String.sub line 0 at) = "picture"
    | None -> false
  in
  List.exists is_file (String.split_on_char '\n' text)

let of_world text = List.sort_uniq compare (List.filter_map snd (lines text))

let without left_out text =
  let line = function text, Some t when List.mem t left_out -> "# " ^ text | text, _ -> text in
  String.concat "\n" (List.map line (lines text))

let needed ~still_fails all =
  if still_fails all then []
  else
    let take_away left_out t = if still_fails (t :: left_out) then t :: left_out else left_out in
    let left_out = List.fold_left take_away [] all in
    List.filter (fun t -> not (List.mem t left_out)) all
