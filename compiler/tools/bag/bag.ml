let is_bag path =
  Filename.check_suffix path ".db3"
  || Filename.check_suffix path ".mcap"
  || (Sys.file_exists path && Sys.is_directory path)

let read ~program bag =
  let cannot reason =
    Error (Printf.sprintf "cannot read the bag %s: %s" (Basis.Printable.name bag) reason)
  in
  let name = Filename.remove_extension (Filename.basename bag) ^ ".csv" in
  let table = Filename.concat (Temporary.folder ()) name in
  let modules = if Filename.check_suffix bag ".mcap" then [ "mcap" ] else [] in
  if not (Sys.file_exists bag) then cannot "it does not exist"
  else
    match Extras.python ~modules with
    | None -> cannot "this needs Python: on Debian, `sudo apt-get install python3-venv`"
    | Some python -> (
        match
          Process.result python [ "-m"; "frob.bag_command"; bag; C_file.name program; table ]
        with
        | Ok _ -> Ok table
        | Error (Failed { errors; _ }) -> cannot (String.trim errors)
        | Error (Not_found _) -> cannot (python ^ " is missing"))

let recording ~program path = if is_bag path then read ~program path else Ok path

let for_its_robot (general : Common_options.t) = function
  | Some path when is_bag path && general.robot = None -> { general with robot = Some "ros" }
  | Some _ | None -> general
