type error = Missing | Unreadable of string

type t = {
  read : string -> (string, error) result;
  modules_in : string -> string list;
  parsed : file:string -> string -> Syntax.Ir.program option;
}

let none_parsed ~file:_ _ = None

let read_regular path =
  match open_in_bin path with
  | exception Sys_error _ -> Error (Unreadable "permission denied")
  | channel ->
      Fun.protect
        ~finally:(fun () -> close_in_noerr channel)
        (fun () ->
          match really_input_string channel (in_channel_length channel) with
          | text -> Ok text
          | exception (Sys_error _ | End_of_file) -> Error (Unreadable "reading failed"))

(* Reads only regular files, because opening a pipe may block forever. *)
let read_on_disk path =
  match (Unix.stat path).st_kind with
  | S_REG -> read_regular path
  | S_DIR -> Error (Unreadable "it is a directory")
  | _ -> Error (Unreadable "it is a pipe or a device, not a file")
  | exception Unix.Unix_error (ENOENT, _, _) -> Error Missing
  | exception Unix.Unix_error (reason, _, _) -> Error (Unreadable (Unix.error_message reason))

let module_of_file file =
  if Filename.check_suffix file ".frob" && Test_file.program file = None then
    Some (Filename.chop_suffix file ".frob")
  else None

let modules files = List.sort String.compare (List.filter_map module_of_file files)

let on_disk =
  let modules_in directory =
    match Sys.readdir directory with
    | files -> modules (Array.to_list files)
    | exception Sys_error _ -> []
  in
  { read = read_on_disk; modules_in; parsed = none_parsed }

let in_memory texts =
  let table = Hashtbl.create 16 in
  List.iter (fun (path, text) -> Hashtbl.replace table path text) texts;
  let read path = Option.to_result ~none:Missing (Hashtbl.find_opt table path) in
  let modules_in directory =
    let inside (path, _) =
      if String.equal (Filename.dirname path) directory then Some (Filename.basename path) else None
    in
    modules (List.filter_map inside texts)
  in
  { read; modules_in; parsed = none_parsed }
