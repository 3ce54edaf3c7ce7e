open General

let world_of given (resources : Resources.t) file =
  let beside = Filename.concat (Filename.dirname file) "world.toml" in
  match given with
  | Some world -> world
  | None when Sys.file_exists beside -> beside
  | None -> Filename.concat resources.worlds "room.toml"

(* Of a program that leaves its robot open, and of a world that does not, it is the
   world's. What is wrong with the world is told before anything that follows from it. *)
let robot_of_world (resources : Resources.t) world =
  match Process.output resources.simulator [ "--robot-of"; world ] with
  | Ok name -> Ok (match String.trim name with "" -> None | name -> Some name)
  | Error (Not_found host) ->
      Error (Printf.sprintf "the host %s is missing: install frobc again" host)
  | Error (Failed { errors; _ }) ->
      let text = String.trim errors and prefix = "error: " in
      let n = if String.starts_with ~prefix text then String.length prefix else 0 in
      Error (String.sub text n (String.length text - n))

let for_world general resources world =
  match general.robot with
  | Some _ -> Ok general
  | None -> Result.map (fun robot -> { general with robot }) (robot_of_world resources world)
