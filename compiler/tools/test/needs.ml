open Checking
open Session

type t = { what : string; command : string }

(* {1 Files next to the program} *)

let beside file is_wanted =
  let folder = Filename.dirname file in
  let path name = if folder = "." then name else Filename.concat folder name in
  Sys.readdir folder |> Array.to_list |> List.sort String.compare |> List.filter is_wanted
  |> List.map path

let c_files file =
  let is_c name = List.exists (Filename.check_suffix name) [ ".c"; ".cc"; ".cpp" ] in
  beside file is_c

let headers file = beside file Own_headers.is_header
let read_or_empty path = Result.value (Own_headers.read path) ~default:""

(* Recognizes the module of a robot by its records for sensors and actuators. *)
let robots file =
  let is_robot path =
    let name = Filename.chop_suffix (Filename.basename path) ".frob" in
    let text = read_or_empty path in
    List.for_all (fun record -> Foreign_symbols.mentions text (name ^ record)) [ "Input"; "Output" ]
  in
  List.filter is_robot (beside file (fun name -> Filename.check_suffix name ".frob"))

(* {1 What the program needs} *)

type needed = {
  own_robot : bool; (* no robot in the library has all required capabilities *)
  calls : string list; (* functions in C *)
  headers : string list; (* headers that the command line does not allow *)
}

let nothing = { own_robot = false; calls = []; headers = [] }

let of_entry context file entry =
  let file = if String.equal entry "main" then Resolve.Test_file.program_or_self file else file in
  let { general; resources; _ } = context in
  let sink = Basis.Diagnostic.sink () in
  match Robots.known general.robot with
  | Error _ -> nothing
  | Ok robot -> (
      let request = Request.make ~options:general ?robot ~entry ~library:resources.library file in
      match Queries.compile sink (Basis.Source.create ()) request with
      | Some files ->
          {
            own_robot = false;
            calls = files.foreign.calls;
            headers = Foreign_files.refused_headers ~name:(C_file.name file) files;
          }
      | None ->
          let is_of_robot (d : Basis.Diagnostic.t) = d.code = Robots.unfit in
          let all = Basis.Diagnostic.all sink in
          { nothing with own_robot = robot = None && List.exists is_of_robot all })

let entries (checks : Checks.t list) =
  let of_check (check : Checks.t) =
    match check.plan with
    | Alone -> [ Resolve.Labels.judge check.name ]
    | Traced _ -> [ "main" ]
    | Simulated _ -> [ "main"; Resolve.Labels.judge check.name ]
  in
  List.sort_uniq String.compare (List.concat_map of_check checks)

let command context file ~robot c_files =
  let program = Resolve.Test_file.program_or_self file in
  let context = { context with general = { context.general with robot }; sources = c_files } in
  Printf.sprintf "frobc test %s%s" (Basis.Printable.path program) (program_words context)

let of_own_robot context file c_files =
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
          what = Printf.sprintf "the robot %s, whose body is written in C" name;
          command = command context file ~robot:(Some robot) bodies;
        }

(* The C files that define the functions the program calls, and any headers that the program
   includes but these files do not. *)
let of_c context file c_files ~calls ~headers =
  let giving = Foreign_symbols.giving ~calls c_files in
  let folders = List.map Filename.dirname giving in
  let reached = Own_headers.reached ~generated:[ C_file.name file ^ ".h" ] ~folders giving in
  match giving @ List.filter (fun header -> not (List.mem header reached)) headers with
  | [] -> None
  | needed ->
      let names = List.map Filename.basename needed in
      Some
        {
          what = "C code in " ^ Basis.Enumeration.all names;
          command = command context file ~robot:context.general.robot needed;
        }

let of_file context file checks =
  match (c_files file, headers file) with
  | _ when context.sources <> [] -> None
  | [], [] -> None
  | c_files, _ -> (
      let needed = List.map (of_entry context file) (entries checks) in
      match List.exists (fun n -> n.own_robot) needed with
      | true -> of_own_robot context file c_files
      | false ->
          of_c context file c_files
            ~calls:(List.concat_map (fun n -> n.calls) needed)
            ~headers:(List.sort_uniq String.compare (List.concat_map (fun n -> n.headers) needed)))

(* {1 Missing libraries} *)

let contains text part =
  let n = String.length part in
  let rec from i = i + n <= String.length text && (String.sub text i n = part || from (i + 1)) in
  from 0

(* This must match the message in runtime/hosts/common/tag_finder.c. *)
let library reason =
  if contains reason "libapriltag" && contains reason "is not installed" then
    Some
      {
        what = "the library libapriltag, which is not installed";
        command = "sudo apt-get install libapriltag-dev";
      }
  else None
