(* Reads the profile from the header of an MCAP file. The profile follows the magic bytes, the
   opcode and two lengths. *)
let profile path =
  let read channel =
    let head = really_input_string channel 21 in
    let length = Int32.to_int (String.get_int32_le head 17) in
    if String.starts_with ~prefix:"\x89MCAP0\r\n\x01" head && length >= 0 && length < 100 then
      Some (really_input_string channel length)
    else None
  in
  match open_in_bin path with
  | exception Sys_error _ -> None
  | channel ->
      Fun.protect
        ~finally:(fun () -> close_in_noerr channel)
        (fun () -> try read channel with End_of_file | Sys_error _ -> None)

let is_bag path =
  Filename.check_suffix path ".db3"
  || (Filename.check_suffix path ".mcap" && profile path = Some "ros2")
  (* If `ros2 bag` has compressed the file, the error message of the reader says what to do. *)
  || List.exists (Filename.check_suffix path) [ ".db3.zstd"; ".mcap.zstd" ]
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
    | None -> cannot "reading it needs Python: on Debian, run `sudo apt-get install python3-venv`"
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
