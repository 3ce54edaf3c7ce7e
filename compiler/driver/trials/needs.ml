open Checking

type t = { what : string; command : string }

(* {1 What lies beside the program} *)

let beside file is_wanted =
  let folder = Filename.dirname file in
  let path name = if folder = "." then name else Filename.concat folder name in
  Sys.readdir folder |> Array.to_list |> List.sort String.compare |> List.filter is_wanted
  |> List.map path

let c_files file =
  let is_c name = List.exists (Filename.check_suffix name) [ ".c"; ".cc"; ".cpp" ] in
  beside file is_c

let read_or_empty path = Result.value (Own_headers.read path) ~default:""

(* A robot's module has the records of what it senses and does. *)
let robots file =
  let is_robot path =
    let name = Filename.chop_suffix (Filename.basename path) ".frob" in
    let text = read_or_empty path in
    List.for_all (fun record -> Foreign_symbols.mentions text (name ^ record)) [ "Input"; "Output" ]
  in
  List.filter is_robot (beside file (fun name -> Filename.check_suffix name ".frob"))

(* {1 What the program needs} *)

type needed = {
  own_robot : bool; (* no robot of the library has all that it asks for *)
  calls : string list; (* in C *)
}

let of_entry context file entry =
  let { general; resources; _ } = context in
  let sink = Basis.Diagnostic.sink () in
  match Robots.known general.robot with
  | Error _ -> { own_robot = false; calls = [] }
  | Ok robot -> (
      let request = General.request general ?robot ~entry ~library:resources.library file in
      match Pipeline.compile sink (Basis.Source.create ()) request with
      | Some files -> { own_robot = false; calls = files.foreign.calls }
      | None ->
          let is_of_robot (d : Basis.Diagnostic.t) = d.code = Robots.unfit in
          let all = Basis.Diagnostic.all sink in
          { own_robot = robot = None && List.exists is_of_robot all; calls = [] })

let entries (checks : Checks.t list) =
  let of_check (check : Checks.t) =
    match check.plan with
    | Alone -> [ Resolve.Labels.judge check.name ]
    | Traced _ -> [ "main" ]
    | Simulated _ -> [ "main"; Resolve.Labels.judge check.name ]
  in
  List.sort_uniq String.compare (List.concat_map of_check checks)

let command file options =
  let option (name, value) = Printf.sprintf " %s %s" name (quoted value) in
  Printf.sprintf "frobc test %s%s" (quoted file) (String.concat "" (List.map option options))

let with_c path = ("--with", path)

let of_own_robot file c_files =
  match robots file with
  | [] -> None
  | robot :: _ ->
      let name = Filename.chop_suffix (Filename.basename robot) ".frob" in
      let body = Printf.sprintf "frob_%s_body" (String.lowercase_ascii name) in
      let bodies =
        List.filter (fun path -> Foreign_symbols.mentions (read_or_empty path) body) c_files
      in
      Some
        {
          what = Printf.sprintf "the robot %s, with its body in C" name;
          command = command file (("--robot", robot) :: List.map with_c bodies);
        }

let of_calls context file c_files calls =
  match Foreign_symbols.giving ~calls c_files with
  | [] -> None
  | giving ->
      let robot =
        match context.general.robot with Some robot -> [ ("--robot", robot) ] | None -> []
      in
      let names = List.map Filename.basename giving in
      Some
        {
          what = "C, in " ^ Basis.Enumeration.all names;
          command = command file (robot @ List.map with_c giving);
        }

let of_file context file checks =
  match c_files file with
  | _ when context.sources <> [] -> None
  | [] -> None
  | c_files -> (
      let needed = List.map (of_entry context file) (entries checks) in
      match List.exists (fun n -> n.own_robot) needed with
      | true -> of_own_robot file c_files
      | false -> of_calls context file c_files (List.concat_map (fun n -> n.calls) needed))
