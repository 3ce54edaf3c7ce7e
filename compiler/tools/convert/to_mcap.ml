(* {1 Groups of columns} *)

(* Arranges columns as nested objects, according to the parts of their names, such as
   [in.sonar[3].x]. The label of an assertion is a single part, whatever characters it contains. *)
type tree = Cell of int * Recorded.kind | Members of (string * tree) list

let is_label part =
  List.exists (fun prefix -> String.starts_with ~prefix part) [ "assert "; "assume " ]

let rec parts name =
  let split i = (String.sub name 0 i, String.sub name (i + 1) (String.length name - i - 1)) in
  match String.index_opt name '.' with
  | _ when is_label name -> [ name ]
  | Some i ->
      let first, rest = split i in
      indexed first @ parts rest
  | None -> indexed name

and indexed name =
  match String.split_on_char '[' name with
  | first :: indices ->
      let index text =
        if String.ends_with ~suffix:"]" text then String.sub text 0 (String.length text - 1)
        else text
      in
      first :: List.map index indices
  | [] -> []

(* The name of the member for a column's own value, if the column's name is a prefix of other
   columns' names. *)
let itself = "value"

let rec add path leaf tree =
  match (path, tree) with
  | [], None -> leaf
  | [], Some (Members list) -> Members (list @ [ (itself, leaf) ])
  | [], Some cell -> cell
  | _, Some (Cell _ as cell) -> add path leaf (Some (Members [ (itself, cell) ]))
  | first :: rest, (None | Some (Members _)) ->
      let list = match tree with Some (Members list) -> list | _ -> [] in
      let inner = add rest leaf (List.assoc_opt first list) in
      if List.mem_assoc first list then
        Members (List.map (fun (name, t) -> (name, if name = first then inner else t)) list)
      else Members (list @ [ (first, inner) ])

let groups (t : Recorded.t) =
  let place (tree, k) (column : Recorded.column) =
    let leaf = Cell (k, column.kind) in
    let path = match parts column.name with [ one ] -> [ one; itself ] | path -> path in
    ((if k = 0 then tree else Some (add path leaf tree)), k + 1)
  in
  match Array.fold_left place (None, 0) t.columns with Some (Members list), _ -> list | _ -> []

let rec schema_of : tree -> Basis.Json.t = function
  | Cell (_, kind) ->
      let name = match kind with Number -> "number" | Truth -> "boolean" | Words -> "string" in
      Object [ ("type", String name) ]
  | Members list ->
      let members = List.map (fun (name, tree) -> (name, schema_of tree)) list in
      Object [ ("type", String "object"); ("properties", Object members) ]

(* The cell in JSON. Empty if the cell is empty. *)
let json (kind : Recorded.kind) text =
  if text = "" then ""
  else
    match kind with Number -> Foxglove.number text | Truth -> text | Words -> Foxglove.words text

let rec add_values b cells = function
  | Cell (k, kind) -> Buffer.add_string b (json kind cells.(k))
  | Members list ->
      let comma = ref false in
      Buffer.add_char b '{';
      List.iter
        (fun (name, tree) ->
          let there =
            match tree with Cell (k, kind) -> json kind cells.(k) <> "" | Members _ -> true
          in
          if there then (
            if !comma then Buffer.add_char b ',';
            comma := true;
            Buffer.add_string b (Foxglove.words name);
            Buffer.add_char b ':';
            add_values b cells tree))
        list;
      Buffer.add_char b '}'

(* {1 The numbers in a row} *)

let finder (t : Recorded.t) =
  let table = Hashtbl.create 64 in
  let see k (c : Recorded.column) = if c.kind = Number then Hashtbl.replace table c.name k in
  Array.iteri see t.columns;
  Hashtbl.find_opt table

let value cells k =
  match float_of_string_opt cells.(k) with
  | Some x when Float.is_finite x -> Some x
  | Some _ | None -> None

(* {1 Poses, ranges and images}

   Each function returns the messages for a row: topic, schema and text. *)

let odometry = "in.odometry"
let fixed_frame = "odometry"
let robot_frame = "robot"

let poses (t : Recorded.t) =
  let find = finder t in
  let of_column (c : Recorded.column) =
    let suffix = ".heading" in
    if not (String.ends_with ~suffix c.name) then None
    else
      let name = String.sub c.name 0 (String.length c.name - String.length suffix) in
      match (find (name ^ ".position.x"), find (name ^ ".position.y"), find c.name) with
      | Some x, Some y, Some heading -> Some (name, (x, y, heading))
      | _ -> None
  in
  List.filter_map of_column (Array.to_list t.columns)

let of_poses poses ~time cells =
  let one (name, (x, y, heading)) =
    match (value cells x, value cells y, value cells heading) with
    | Some x, Some y, Some heading ->
        let pose = { Foxglove.x; y; heading } in
        let text = Foxglove.of_pose ~time ~frame:fixed_frame pose in
        let here = ("/pose/" ^ name, Foxglove.pose_in_frame, text) in
        if name <> odometry then [ here ]
        else
          let text = Foxglove.of_transform ~time ~parent:fixed_frame ~child:robot_frame pose in
          [ ("/tf", Foxglove.frame_transform, text); here ]
    | _ -> []
  in
  List.concat_map one poses

(* In ns. Somewhat longer than the sonar takes to fire all transducers once. *)
let echo_lasts = 700_000_000

let of_ranges find seats =
  let known =
    List.filter_map (fun (s : Seats.seat) -> Option.map (fun k -> (s, k)) (find s.column)) seats
  in
  fun ~time cells ->
    let echo ((s : Seats.seat), k) =
      Option.map
        (fun range ->
          {
            Foxglove.id = s.column;
            seat = { x = s.x; y = s.y; heading = s.heading };
            half_angle = s.half_angle;
            range;
            lasts = echo_lasts;
          })
        (value cells k)
    in
    match List.filter_map echo known with
    | [] -> []
    | echoes ->
        [ ("/ranges", Foxglove.scene_update, Foxglove.of_echoes ~time ~frame:robot_frame echoes) ]

(* {1 Camera frames} *)

(* Maximum size in bytes. It is larger than any camera frame. *)
let largest_frame = 1 lsl 28

type frames = { folder : string; mutable missing : int }

let of_image frames ~time topic (frame : Frame_cell.t) =
  let read ending =
    let path = Filename.concat frames.folder (frame.file ^ ending) in
    if Sys.file_exists path then Result.to_option (Packed.read ~most:largest_frame path) else None
  in
  let found ending = Option.bind (read ending) (Foxglove.image ~file:(frame.file ^ ending)) in
  match match found ".ppm" with Some image -> Some image | None -> found ".pgm" with
  | Some image ->
      let time = max 0 (time - frame.age) in
      Some (topic, Foxglove.raw_image, Foxglove.of_image ~time ~frame:topic image)
  | None ->
      frames.missing <- frames.missing + 1;
      None

let of_images (t : Recorded.t) frames ~time cells =
  let of_column k (c : Recorded.column) =
    if c.kind <> Words then []
    else
      let images = Frame_cell.all cells.(k) in
      let topic n = "/image/" ^ c.name ^ if n = 0 then "" else Printf.sprintf "/%d" (n + 1) in
      let one n frame = of_image frames ~time (topic n) frame in
      List.filter_map Fun.id (List.mapi one images)
  in
  List.concat (List.mapi of_column (Array.to_list t.columns))

(* {1 The whole file} *)

let media_type path =
  if Filename.check_suffix path ".gz" then "application/gzip"
  else if Filename.check_suffix path ".zst" then "application/zstd"
  else "text/csv"

let attach writer path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in_noerr channel)
    (fun () ->
      Mcap_writer.attach writer ~name:(Filename.basename path) ~media_type:(media_type path) channel)

let write resources (t : Recorded.t) out =
  let writer = Mcap_writer.start out in
  attach writer t.path;
  if t.params <> [] then Mcap_writer.metadata writer ~name:"params" t.params;
  let channels = Hashtbl.create 16 in
  let send ~time (topic, schema, text) =
    let channel =
      match Hashtbl.find_opt channels topic with
      | Some channel -> channel
      | None ->
          let channel = Mcap_writer.channel writer ~topic ~schema in
          Hashtbl.replace channels topic channel;
          channel
    in
    Mcap_writer.message writer channel ~time text
  in
  let group (name, tree) =
    let schema = ("frob." ^ name, Basis.Json.to_string (schema_of tree)) in
    fun cells ->
      let b = Buffer.create 1024 in
      add_values b cells tree;
      ("/" ^ name, schema, Buffer.contents b)
  in
  let groups = List.map group (groups t) in
  let names = Array.to_list (Array.map (fun (c : Recorded.column) -> c.name) t.columns) in
  let frames = { folder = Frame_cell.folder_of t.path; missing = 0 } in
  let poses = poses t and ranges = of_ranges (finder t) (Seats.of_columns resources names) in
  let row ~time cells =
    List.iter (fun group -> send ~time (group cells)) groups;
    List.iter (send ~time) (of_poses poses ~time cells);
    List.iter (send ~time) (ranges ~time cells);
    List.iter (send ~time) (of_images t frames ~time cells)
  in
  Result.map
    (fun () ->
      Mcap_writer.finish writer;
      if frames.missing > 0 then
        Printf.eprintf
          "warning: %d frames named in %s are missing from %s or are not valid; they were omitted\n"
          frames.missing (Basis.Printable.name t.path)
          (Basis.Printable.name frames.folder))
    (Recorded.iter t row)
