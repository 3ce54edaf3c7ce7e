open Common_options

type from = Here | Beside of string

let beside file name =
  let folder = Filename.dirname file in
  if folder = Filename.current_dir_name then name else Filename.concat folder name

let readable path =
  match Unix.openfile path [ O_RDONLY; O_CLOEXEC ] 0 with
  | exception Unix.Unix_error (reason, _, _) -> Error (Unix.error_message reason)
  | file ->
      Fun.protect
        ~finally:(fun () -> Unix.close file)
        (fun () ->
          match Unix.read file (Bytes.create 1) 0 1 with
          | _ -> Ok path
          | exception Unix.Unix_error (reason, _, _) -> Error (Unix.error_message reason))

(* The list of available worlds, for messages. *)
let own (resources : Resources.t) =
  match Sys.readdir resources.worlds with
  | names -> String.concat ", " (List.sort String.compare (Array.to_list names))
  | exception Sys_error _ -> "none"

let find (resources : Resources.t) places name =
  let path = function Here -> name | Beside file -> beside file name in
  let called = function Here -> "here" | Beside file -> "next to " ^ Basis.Printable.name file in
  let is_relative = Filename.is_relative name in
  let candidates =
    if is_relative then List.map path places @ [ Filename.concat resources.worlds name ]
    else [ name ]
  in
  match List.find_opt Sys.file_exists candidates with
  | Some path ->
      Result.map_error
        (Printf.sprintf "cannot read the world `%s`: %s" (Basis.Printable.name path))
        (readable path)
  | None when is_relative ->
      Error
        (Printf.sprintf "there is no world `%s` %s or among the worlds that come with frobc: %s"
           (Basis.Printable.name name)
           (String.concat " or " (List.map called places))
           (own resources))
  | None -> Error (Printf.sprintf "there is no world `%s`" (Basis.Printable.name name))

let world_of given (resources : Resources.t) file =
  let beside_it = Filename.concat (Filename.dirname file) "world.toml" in
  match given with
  | Some name -> find resources [ Here; Beside file ] name
  | None when Sys.file_exists beside_it -> Ok beside_it
  | None -> Ok (Filename.concat resources.worlds "room.toml")

(* The robot that the world names, for a program that does not name one. Errors in the world are
   reported before any errors that they cause. *)
let robot_of_world (resources : Resources.t) world =
  match Process.result resources.simulator [ "--robot-of"; world ] with
  | Ok name -> Ok (match String.trim name with "" -> None | name -> Some name)
  | Error (Not_found host) -> Error (Printf.sprintf "the host %s is missing: reinstall frobc" host)
  | Error (Failed { errors; _ }) ->
      let text = String.trim errors and prefix = "error: " in
      let n = if String.starts_with ~prefix text then String.length prefix else 0 in
      Error (String.sub text n (String.length text - n))

let for_world general resources world =
  match general.robot with
  | Some _ -> Ok general
  | None -> Result.map (fun robot -> { general with robot }) (robot_of_world resources world)
