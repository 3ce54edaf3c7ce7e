open Basis.Let_syntax.Result
module F = Message_file

(* {1 Finding definitions} *)

let definition ~package ~name =
  match Message_definitions.in_ros2 ~package ~name with
  | Defined definition -> Ok definition
  | Unreadable why -> Error why
  | No_message messages ->
      Error
        (Printf.sprintf "the package %s has no message %s%s" package name
           (match Basis.Suggest.closest name messages with
           | Some other -> Printf.sprintf "; did you mean %s/%s?" package other
           | None -> ", but " ^ Basis.Enumeration.some messages ~more:0))
  | No_package when Message_definitions.prefixes () = [] ->
      Error
        "ROS 2 is not set up in this shell: source its setup script, which sets AMENT_PREFIX_PATH, \
         for example with `source /opt/ros/jazzy/setup.bash`"
  | No_package ->
      Error
        (Printf.sprintf
           "ROS 2 in this shell (AMENT_PREFIX_PATH) has no package %s with messages: install it, \
            or source the setup script of its workspace"
           package)

(* {1 Names} *)

let capitalized word = String.capitalize_ascii word

(* For the constant [POWER_OK] of [BatteryState], returns [batteryStatePowerOk]. *)
let constant_name ~type_ constant =
  let words = List.filter (fun word -> word <> "") (String.split_on_char '_' constant) in
  String.uncapitalize_ascii type_
  ^ String.concat "" (List.map (fun word -> capitalized (String.lowercase_ascii word)) words)

(* {1 Units} *)

let unit_words =
  [
    ([ "m"; "meter"; "meters"; "metre"; "metres" ], "m");
    ([ "rad"; "radian"; "radians" ], "rad");
    ([ "m/s"; "m s^-1" ], "m/s");
    ([ "rad/s"; "radians/second"; "radians/s" ], "rad/s");
    ([ "m/s^2"; "m/s2"; "m/s/s" ], "m/s^2");
    ([ "rad/s^2"; "rad/s2" ], "rad/s^2");
    ([ "s"; "sec"; "second"; "seconds" ], "s");
    ([ "Hz"; "hertz" ], "Hz");
    ([ "V"; "volt"; "volts" ], "V");
    ([ "A"; "ampere"; "amperes" ], "A");
    ([ "W"; "watt"; "watts" ], "W");
    ([ "N"; "newton"; "newtons" ], "N");
    ([ "Nm"; "N m"; "N*m" ], "N m");
    ([ "Pa"; "pascal"; "pascals" ], "Pa");
    ([ "kg" ], "kg");
    ([ "K"; "kelvin" ], "K");
  ]

(* A unit that a comment states in brackets or in words: "[m/s]", "(rad)", "in meters". *)
let unit_of comment =
  let stated = Str.regexp "[[(]\\([^])]+\\)[])]\\|\\bin \\([A-Za-z/^0-9]+\\)" in
  let group k = try Some (Str.matched_group k comment) with Not_found -> None in
  let rec search from =
    match Str.search_forward stated comment from with
    | exception Not_found -> None
    | at -> (
        let word = match group 1 with Some word -> Some word | None -> group 2 in
        let next = at + max 1 (String.length (Str.matched_string comment)) in
        let word = String.trim (Option.value word ~default:"") in
        let is_it other =
          other = word || (String.length word > 2 && other = String.lowercase_ascii word)
        in
        let known (words, _) = List.exists is_it words in
        match List.find_opt known unit_words with
        | Some (_, unit_) -> Some unit_
        | None -> search next)
  in
  search 0

(* {1 Types} *)

type context = {
  most : int;
  mutable imports : (string * string) list;  (** each imported name, preceded by its module *)
  mutable records : (string * string) list;  (** each message type, with the name of its record *)
  mutable written : string list;  (** the declarations, in reverse order *)
}

let use c module_ name =
  if not (List.mem (module_, name) c.imports) then c.imports <- (module_, name) :: c.imports

let is_header (f : F.field) = f.base = Message { package = "std_msgs"; name = "Header" }

(* A field of the record, or the reason why it is omitted. *)
type kept = Kept of { type_ : string; remark : string } | Left_out of string

let with_unit name comment =
  match unit_of comment with
  | Some unit_ -> (Printf.sprintf "%s[%s]" name unit_, "")
  | None -> (name, "")

let one_line text =
  String.concat " "
    (List.filter (fun word -> word <> "") (String.split_on_char ' ' (String.trim text)))

(* Aligns the comments of the lines in one column, and truncates comments that are too long for a
   line. *)
let commented lines =
  let width = List.fold_left (fun width (code, _) -> max width (String.length code)) 0 lines in
  let line (code, comment) =
    let room = 100 - 6 - width - 7 in
    let comment =
      if String.length comment <= room then comment else String.sub comment 0 (max 0 room) ^ "..."
    in
    Printf.sprintf "%-*s    -- %s" width code comment
  in
  List.map line lines

let rec all f = function
  | [] -> Ok []
  | first :: others ->
      let* first = f first in
      let* others = all f others in
      Ok (first :: others)

let rec type_of c (f : F.field) =
  match f.base with
  | Truth -> Ok (Some ("Bool", ""))
  | Real _ -> Ok (Some (with_unit "Float" f.comment))
  | Whole { bits; signed } ->
      let is_large = bits = 64 || (bits = 32 && not signed) in
      Ok (Some ("Int", if is_large then "larger numbers become the nearest Int" else ""))
  | Text -> Ok None
  | Message { package = "geometry_msgs"; name = "Vector3" } ->
      use c "Geometry" "Vec3";
      let unit_ = Option.value (unit_of f.comment) ~default:"1" in
      Ok (Some (Printf.sprintf "Vec3[%s]" unit_, ""))
  | Message { package; name } -> (
      match List.assoc_opt (package, name) Library_messages.all with
      | Some (module_, name, type_) ->
          use c module_ name;
          Ok (Some (type_, ""))
      | None ->
          record c ~package ~name
          |> Result.map (Option.map (fun record -> (record, "")))
          |> Result.map_error (Printf.sprintf "the field `%s`: %s" f.name))

and kept c (f : F.field) =
  if is_header f then Ok (Left_out "the node sets the stamp")
  else
    let* type_ = type_of c f in
    Ok
      (match type_ with
      | None when f.base = Text ->
          Left_out "text: an enumeration with an instance of `RosText` could represent it"
      | None -> Left_out "it contains only text"
      | Some (type_, remark) -> (
          let argument = if String.contains type_ ' ' then "(" ^ type_ ^ ")" else type_ in
          let upto n = Printf.sprintf "Upto %d %s" n argument in
          match f.length with
          | One -> Kept { type_; remark }
          | Exactly n -> Kept { type_ = Printf.sprintf "Array %d %s" n argument; remark }
          | At_most n ->
              use c "Ros" "Upto";
              Kept { type_ = upto n; remark }
          | Any ->
              use c "Ros" "Upto";
              Kept { type_ = upto c.most; remark = "unbounded in ROS" }))

(* Declares the record for a message, after the records for its parts. Returns the name of the
   record, or [None] if Frob cannot represent any of the message's fields. *)
and record c ~package ~name =
  let type_ = package ^ "/msg/" ^ name in
  match List.assoc_opt type_ c.records with
  | Some record -> Ok (Some record)
  | None ->
      let* definition = definition ~package ~name in
      let is_taken record =
        List.exists (fun (_, other) -> String.equal other record) c.records
        || List.exists (fun (_, (_, other, _)) -> String.equal other record) Library_messages.all
      in
      let record = if is_taken name then capitalized package ^ name else name in
      let* fields = all (kept c) definition.fields in
      c.records <- (type_, record) :: c.records;
      Ok (declare c ~type_ ~record definition (List.combine definition.fields fields))

and declare c ~type_ ~record (definition : F.t) fields =
  let field ((f : F.field), kept) =
    match kept with
    | Left_out _ -> None
    | Kept { type_; remark } ->
        let about = [ F.type_text f; remark; one_line f.comment ] in
        Some
          ( Printf.sprintf "%s :: %s" (F.frob_name f.name) type_,
            String.concat "; " (List.filter (fun text -> text <> "") about) )
  in
  let left_out ((f : F.field), kept) =
    match kept with
    | Left_out why -> Some (Printf.sprintf "-- Omitted: %s %s (%s).\n" (F.type_text f) f.name why)
    | Kept _ -> None
  in
  let constants = List.filter_map (constant ~record) definition.constants in
  match List.filter_map field fields with
  | [] -> None
  | kept ->
      c.written <-
        Printf.sprintf
          "-- | The message %s.\n\
           %sdata %s = %s\n\
          \    { %s\n\
          \    }\n\n\
           instance Message %s where\n\
          \    rosType _ = \"%s\"\n\
           %s"
          type_
          (String.concat "" (List.filter_map left_out fields))
          record record
          (String.concat "\n    , " (commented kept))
          record type_ (String.concat "" constants)
        :: c.written;
      Some record

and constant ~record (k : F.constant) =
  let name = constant_name ~type_:record k.constant in
  let written type_ value =
    Some
      (Printf.sprintf "\n-- | The constant %s.\n%s :: %s\n%s = %s\n" k.constant name type_ name
         value)
  in
  match k.base with
  | Truth -> written "Bool" (if List.mem k.value [ "true"; "True"; "1" ] then "True" else "False")
  | Real _ -> written "Float" k.value
  | Whole _ -> written "Int" k.value
  | Text | Message _ -> None

(* {1 The module} *)

let module_text c ~module_ ~type_ =
  use c "Ros" "Message";
  let modules = List.sort_uniq compare (List.map fst c.imports) in
  let import module_ =
    let names = List.filter_map (fun (m, n) -> if m = module_ then Some n else None) c.imports in
    Printf.sprintf "import %s (%s)\n" module_ (String.concat ", " (List.sort compare names))
  in
  Printf.sprintf
    "-- Generated from the message %s by `frobc ros2 import`.\n\
     -- You can edit this file: remove fields, or change units and the sizes of sequences.\n\
     module %s where\n\n\
     %s\n\
     %s"
    type_ module_
    (String.concat "" (List.map import modules))
    (String.concat "\n" (List.rev c.written))

let split text =
  match String.split_on_char '/' text with
  | ([ package; name ] | [ package; "msg"; name ]) when F.is_name package && F.is_name name ->
      Ok (package, name)
  | _ ->
      Error
        (Printf.sprintf
           "write the package and the type of the message, as in my_msgs/Wheels, not `%s`"
           (Basis.Printable.name text))

let formatted ~file text =
  match Formatting.Formatter.text (Basis.Facts.ignored ()) ~file text with
  | Formatted text -> text
  | Broken | Refused _ -> text

let import ~most ~output asked =
  Reporting.(
    let* package, name = split asked in
    let path = Option.value output ~default:(name ^ "Msg.frob") in
    let module_ = Filename.remove_extension (Filename.basename path) in
    let c = { most; imports = []; records = []; written = [] } in
    let* record = record c ~package ~name in
    let* () =
      match record with
      | Some _ -> Ok ()
      | None ->
          Error
            (Printf.sprintf "%s has no field that Frob can represent: it contains only text" asked)
    in
    let* () =
      if Sys.file_exists path then
        Error
          (Printf.sprintf
             "%s already exists: move it away, or write to another file with `-o OTHER.frob`"
             (Basis.Printable.name path))
      else Ok ()
    in
    let text = module_text c ~module_ ~type_:(package ^ "/msg/" ^ name) in
    let* () = Output.write [ (path, formatted ~file:path text) ] in
    Printf.printf "%s: import it with `import %s`\n" path module_;
    Exit_status.ok)
