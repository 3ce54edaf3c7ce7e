type found =
  | Defined of Message_file.t
  | No_message of string list
  | No_package
  | Unreadable of string

let ( / ) = Filename.concat

let prefixes () =
  List.filter
    (fun prefix -> prefix <> "")
    (String.split_on_char ':' (Option.value (Sys.getenv_opt "AMENT_PREFIX_PATH") ~default:""))

let messages_in folder =
  Array.to_list (Sys.readdir folder)
  |> List.filter (fun file -> Filename.check_suffix file ".msg")
  |> List.map Filename.remove_extension
  |> List.sort compare

let read ~package file =
  match
    Result.bind
      (Result.map_error (Printf.sprintf "%s: %s" file) (Own_headers.read file))
      (Message_file.parse ~package ~file)
  with
  | Ok definition -> Defined definition
  | Error why -> Unreadable why

let in_ros2 ~package ~name =
  let folders = List.map (fun prefix -> prefix / "share" / package / "msg") (prefixes ()) in
  let existing = List.filter (fun f -> Sys.file_exists f && Sys.is_directory f) folders in
  let file folder = folder / (name ^ ".msg") in
  match (List.find_opt (fun folder -> Sys.file_exists (file folder)) existing, existing) with
  | Some folder, _ -> read ~package (file folder)
  | None, folder :: _ -> No_message (messages_in folder)
  | None, [] -> No_package

(* {1 Common packages} *)

let common =
  lazy
    (let add (known, lines) line =
       match String.split_on_char ' ' line with
       | [ "MSG:"; type_ ] -> ((type_, String.concat "\n" lines) :: known, [])
       | _ -> (known, line :: lines)
     in
     (* Reads the lines in reverse, so that all lines of a definition have been collected when its
        name is reached. *)
     let lines = List.rev (String.split_on_char '\n' Known_messages.text) in
     fst (List.fold_left add ([], []) lines))

let find ~package ~name =
  match in_ros2 ~package ~name with
  | No_package -> (
      let file = package ^ "/" ^ name in
      match List.assoc_opt file (Lazy.force common) with
      | Some text -> (
          match Message_file.parse ~package ~file text with
          | Ok definition -> Defined definition
          | Error why -> Basis.Diagnostic.bug ~stage:"Message_definitions" "%s" why)
      | None -> No_package)
  | found -> found
