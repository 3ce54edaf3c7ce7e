open Basis

type schema = string * string

let number text =
  match float_of_string text with
  | x when Float.is_nan x || Float.abs x = infinity -> ""
  | x -> (
      (* Keeps the text if it is already a JSON number, which must have digits on both sides of the
         decimal point and no leading plus sign. *)
      let n = String.length text in
      let digit i = i < n && text.[i] >= '0' && text.[i] <= '9' in
      let first = if text.[0] = '-' then 1 else 0 in
      let is_plain = function '0' .. '9' | '.' | '-' | '+' | 'e' | 'E' -> true | _ -> false in
      let leading_zero = digit first && text.[first] = '0' && digit (first + 1) in
      match String.index_opt text '.' with
      | _ when (not (digit first && String.for_all is_plain text)) || leading_zero ->
          Printf.sprintf "%.17g" x
      | Some point when not (digit (point + 1)) -> Printf.sprintf "%.17g" x
      | Some _ | None -> text)

let words text = Json.to_string (String text)

(* {1 Schemas} *)

let typed name more : Json.t = Object (("type", Json.String name) :: more)
let a_number = typed "number" []
let an_integer = typed "integer" []
let a_string = typed "string" []
let members list = typed "object" [ ("properties", Json.Object list) ]
let many item = typed "array" [ ("items", item) ]

let seconds title =
  typed "object"
    [
      ("title", Json.String title);
      ("properties", Json.Object [ ("sec", an_integer); ("nsec", an_integer) ]);
    ]

let time = seconds "time"
let vector = members [ ("x", a_number); ("y", a_number); ("z", a_number) ]
let quaternion = members [ ("x", a_number); ("y", a_number); ("z", a_number); ("w", a_number) ]
let a_pose = members [ ("position", vector); ("orientation", quaternion) ]
let colour = members [ ("r", a_number); ("g", a_number); ("b", a_number); ("a", a_number) ]

let schema name fields : schema =
  let title = ("title", Json.String name) in
  let described =
    match members fields with Object list -> Json.Object (title :: list) | other -> other
  in
  (name, Json.to_string described)

let pose_in_frame =
  schema "foxglove.PoseInFrame" [ ("timestamp", time); ("frame_id", a_string); ("pose", a_pose) ]

let frame_transform =
  schema "foxglove.FrameTransform"
    [
      ("timestamp", time);
      ("parent_frame_id", a_string);
      ("child_frame_id", a_string);
      ("translation", vector);
      ("rotation", quaternion);
    ]

(* The kinds of shapes, other than lines, that an entity can contain. *)
let other_shapes = [ "arrows"; "cubes"; "spheres"; "cylinders"; "triangles"; "texts"; "models" ]

let scene_update =
  let line =
    members
      [
        ("type", an_integer);
        ("pose", a_pose);
        ("thickness", a_number);
        ("scale_invariant", typed "boolean" []);
        ("points", many vector);
        ("color", colour);
        ("colors", many colour);
        ("indices", many an_integer);
      ]
  in
  let nothing name = (name, many (members [])) in
  let entity =
    members
      ([
         ("timestamp", time);
         ("frame_id", a_string);
         ("id", a_string);
         ("lifetime", seconds "duration");
         ("frame_locked", typed "boolean" []);
         nothing "metadata";
         ("lines", many line);
       ]
      @ List.map nothing other_shapes)
  in
  schema "foxglove.SceneUpdate" [ nothing "deletions"; ("entities", many entity) ]

let raw_image =
  schema "foxglove.RawImage"
    [
      ("timestamp", time);
      ("frame_id", a_string);
      ("width", an_integer);
      ("height", an_integer);
      ("encoding", a_string);
      ("step", an_integer);
      ("file", a_string);
      ("head", a_string);
      ("data", typed "string" [ ("contentEncoding", Json.String "base64") ]);
    ]

(* {1 Messages} *)

let of_time ns : Json.t =
  Object [ ("sec", Int (ns / 1_000_000_000)); ("nsec", Int (ns mod 1_000_000_000)) ]

let of_vector (x, y) : Json.t = Object [ ("x", Float x); ("y", Float y); ("z", Int 0) ]

type pose = { x : float; y : float; heading : float }

(* These functions return the same bits on every machine. *)
module Elementary = (val Elementary.of_precision Real.Double)

(* Quaternion of a rotation about the vertical axis. *)
let of_heading heading : Json.t =
  let half = heading /. 2. in
  Object
    [
      ("x", Int 0);
      ("y", Int 0);
      ("z", Float (Elementary.sin half));
      ("w", Float (Elementary.cos half));
    ]

let placed { x; y; heading } : Json.t =
  Object [ ("position", of_vector (x, y)); ("orientation", of_heading heading) ]

let of_pose ~time ~frame pose =
  Json.to_string
    (Object [ ("timestamp", of_time time); ("frame_id", String frame); ("pose", placed pose) ])

let of_transform ~time ~parent ~child { x; y; heading } =
  Json.to_string
    (Object
       [
         ("timestamp", of_time time);
         ("parent_frame_id", String parent);
         ("child_frame_id", String child);
         ("translation", of_vector (x, y));
         ("rotation", of_heading heading);
       ])

type echo = { id : string; seat : pose; half_angle : float; range : float; lasts : int }

let line_loop = 1
let arc_points = 5
let blue : Json.t = Object [ ("r", Float 0.1); ("g", Float 0.5); ("b", Int 1); ("a", Int 1) ]

let cone { seat; half_angle; range; _ } : Json.t =
  let along k =
    let angle = half_angle *. ((2. *. float_of_int k /. float_of_int (arc_points - 1)) -. 1.) in
    of_vector (range *. Elementary.cos angle, range *. Elementary.sin angle)
  in
  Object
    [
      ("type", Int line_loop);
      ("pose", placed seat);
      ("thickness", Float 0.01);
      ("scale_invariant", Bool false);
      ("points", List (of_vector (0., 0.) :: List.init arc_points along));
      ("color", blue);
      ("colors", List []);
      ("indices", List []);
    ]

let of_echoes ~time ~frame echoes =
  let entity echo : Json.t =
    Object
      ([
         ("timestamp", of_time time);
         ("frame_id", Json.String frame);
         ("id", String echo.id);
         ("lifetime", of_time echo.lasts);
         ("frame_locked", Bool true);
         ("metadata", List []);
         ("lines", List [ cone echo ]);
       ]
      @ List.map (fun name -> (name, Json.List [])) other_shapes)
  in
  Json.to_string (Object [ ("deletions", List []); ("entities", List (List.map entity echoes)) ])

(* {1 Images} *)

type image = { file : string; head : string; width : int; height : int; pixels : string }

(* Parses the header of a PPM or PGM file: one line each for the magic number, comments, width and
   height, and the maximum value (<frob/frame.h>). *)
let image ~file text =
  let rec head_end at size =
    match String.index_from_opt text at '\n' with
    | None -> None
    | Some line_end -> (
        let line = String.sub text at (line_end - at) in
        match (line, size) with
        | "255", Some size -> Some (line_end + 1, size)
        | _ when line <> "" && line.[0] = '#' -> head_end (line_end + 1) size
        | _ -> (
            match List.map int_of_string_opt (String.split_on_char ' ' line) with
            | [ Some width; Some height ] -> head_end (line_end + 1) (Some (width, height))
            | _ -> None))
  in
  let bytes = if String.starts_with ~prefix:"P5\n" text then 1 else 3 in
  if not (bytes = 1 || String.starts_with ~prefix:"P6\n" text) then None
  else
    match head_end 3 None with
    | Some (start, (width, height))
      when String.length text - start = width * height * bytes && width > 0 && height > 0 ->
        let pixels = String.sub text start (String.length text - start) in
        Some { file; head = String.sub text 0 start; width; height; pixels }
    | Some _ | None -> None

let of_image ~time ~frame { file; head; width; height; pixels } =
  let is_grey = head.[1] = '5' in
  let fields =
    Json.to_string
      (Object
         [
           ("timestamp", of_time time);
           ("frame_id", String frame);
           ("width", Int width);
           ("height", Int height);
           ("encoding", String (if is_grey then "mono8" else "rgb8"));
           ("step", Int (if is_grey then width else 3 * width));
           ("file", String file);
           ("head", String head);
         ])
  in
  let b = Buffer.create (String.length fields + (String.length pixels * 4 / 3) + 20) in
  Buffer.add_substring b fields 0 (String.length fields - 1);
  Buffer.add_string b ",\"data\":\"";
  Base64.encode b pixels;
  Buffer.add_string b "\"}";
  Buffer.contents b

(* The value of a string member in a message that this module has written. The only escape sequence
   in a header is the line feed. *)
let member name message =
  let mark = Printf.sprintf "\"%s\":\"" name in
  let n = String.length mark and length = String.length message in
  let rec find i =
    if i + n > length then None
    else if String.equal (String.sub message i n) mark then Some (i + n)
    else Option.bind (String.index_from_opt message (i + 1) '"') find
  in
  let rec read b i =
    match if i < length then message.[i] else '\000' with
    | '"' -> Some (Buffer.contents b)
    | '\\' when i + 1 < length && message.[i + 1] = 'n' ->
        Buffer.add_char b '\n';
        read b (i + 2)
    | '\\' | '\000' -> None
    | c ->
        Buffer.add_char b c;
        read b (i + 1)
  in
  Option.bind (find 0) (read (Buffer.create 256))

let file_of message =
  let pixels = Option.bind (member "data" message) Base64.decode in
  match (member "file" message, member "head" message, pixels) with
  | Some file, Some head, Some pixels -> Some (file, head ^ pixels)
  | _ -> None
