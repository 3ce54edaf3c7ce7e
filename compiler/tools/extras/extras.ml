let ( / ) = Filename.concat

open Basis.Let_syntax.Result

type group = { name : string; packages : (string * string) list; purpose : string }

let groups =
  [
    {
      name = "search";
      packages = [ ("numpy", "numpy"); ("cma", "cma") ];
      purpose = "frobc falsify";
    };
    {
      name = "mcap";
      packages = [ ("mcap", "mcap") ];
      purpose = "frobc convert with MCAP files from other programs";
    };
    {
      name = "ros";
      packages = [ ("mcap", "mcap"); ("mcap-ros2-support", "mcap_ros2") ];
      purpose = "frobc convert with ROS 2 bags in MCAP files";
    };
    {
      name = "jupyter";
      packages =
        [
          ("jupyterlab", "jupyterlab");
          ("numpy", "numpy");
          ("pandas", "pandas");
          ("matplotlib", "matplotlib");
        ];
      purpose = "notebooks";
    };
    {
      name = "cluster";
      packages = [ ("numpy", "numpy"); ("distributed", "distributed") ];
      purpose = "sweeps on a Dask cluster";
    };
  ]

let command name = "frobc extras install " ^ name
let of_name name = List.find_opt (fun g -> g.name = name) groups

(* {1 The environment} *)

let folder () =
  let absolute variable =
    match Sys.getenv_opt variable with
    | Some path when not (Filename.is_relative path) -> Some path
    | Some _ | None -> None
  in
  match (absolute "XDG_DATA_HOME", absolute "HOME") with
  | Some data, _ -> Ok (data / "frobc")
  | None, Some home -> Ok (home / ".local" / "share" / "frobc")
  | None, None -> Error "HOME is not set: set XDG_DATA_HOME to a folder for the packages"

(* A symbolic link to the environment, so that a new environment replaces the old one in one step.
   *)
let link folder = folder / "python"
let python_of environment = environment / "bin" / "python3"
let installed_groups environment = environment / "frobc-groups"

let read path =
  match Resolve.Files.on_disk.read path with
  | Ok text -> String.split_on_char '\n' text |> List.filter (( <> ) "")
  | Error (Missing | Unreadable _) -> []

let environment () =
  match folder () with
  | Ok folder when Sys.file_exists (link folder) -> Some (link folder)
  | Ok _ | Error _ -> None

(* {1 Python} *)

let works python = Result.is_ok (Process.output python [ "-c"; "" ])

let has python modules =
  let test =
    "import sys, importlib.util\n\
     sys.exit(any(importlib.util.find_spec(name) is None for name in sys.argv[1:]))"
  in
  Result.is_ok (Process.output python ("-c" :: test :: modules))

let package () =
  Result.to_option (Installation.find ()) |> Option.map (fun (r : Resources.t) -> r.python)

let with_package python =
  if not (has python [ "frob" ]) then
    Option.iter
      (fun package ->
        let others = match Sys.getenv_opt "PYTHONPATH" with Some p -> ":" ^ p | None -> "" in
        Unix.putenv "PYTHONPATH" (package ^ others))
      (package ())

let candidates () =
  match Sys.getenv_opt "VIRTUAL_ENV" with
  | Some environment when environment <> "" -> [ python_of environment ]
  | Some _ | None ->
      List.map python_of (Option.to_list (environment ()))
      @ List.filter (( <> ) "") (Option.to_list (Sys.getenv_opt "FROB_PYTHON"))
      @ [ "python3" ]

let python ~modules =
  let usable = List.filter works (candidates ()) in
  let chosen =
    match List.find_opt (fun python -> has python modules) usable with
    | Some python -> Some python
    | None -> List.nth_opt usable 0
  in
  Option.iter with_package chosen;
  chosen

(* {1 Installing} *)

let last_lines text =
  let lines = List.filter (( <> ) "") (String.split_on_char '\n' (String.trim text)) in
  let skipped = List.length lines - 6 in
  String.concat "\n" (List.filteri (fun k _ -> k >= skipped) lines)

let has_word word text =
  let n = String.length word in
  let rec from k = k + n <= String.length text && (String.sub text k n = word || from (k + 1)) in
  from 0

(* Without a network connection, pip reports that the package has no versions. *)
let refused packages errors =
  let offline =
    List.exists
      (fun word -> has_word word errors)
      [ "NewConnectionError"; "Name or service"; "name resolution"; "Network is unreachable" ]
  in
  if offline then
    Printf.sprintf "cannot install %s: there is no connection to the Python package index"
      (String.concat ", " packages)
  else
    Printf.sprintf "cannot install %s; pip reported:\n%s" (String.concat ", " packages)
      (last_lines errors)

let make_environment path =
  let missing =
    "`frobc extras` needs Python with the module venv: on Debian, run `sudo apt-get install \
     python3-venv`"
  in
  let base =
    match Sys.getenv_opt "FROB_PYTHON" with
    | Some python when python <> "" && works python -> python
    | Some _ | None -> "python3"
  in
  match Process.output base [ "-m"; "venv"; path ] with
  | Ok _ -> Ok ()
  | Error (Not_found _) -> Error missing
  | Error (Failed { errors; _ }) when has_word "ensurepip" errors || has_word "No module" errors ->
      Error missing
  | Error (Failed { errors; _ }) ->
      Error (Printf.sprintf "cannot create %s:\n%s" path (last_lines errors))

(* Makes the package frob that belongs to this frobc visible in the environment. *)
let add_own_package environment =
  match
    ( package (),
      Process.output (python_of environment)
        [ "-c"; "import sysconfig; print(sysconfig.get_path('purelib'))" ] )
  with
  | Some package, Ok site -> Output.write [ (String.trim site / "frobc.pth", package ^ "\n") ]
  | None, _ | _, Error _ -> Ok ()

let remove_others folder =
  let current = try Unix.readlink (link folder) with Unix.Unix_error _ -> "" in
  Array.iter
    (fun name ->
      if String.starts_with ~prefix:"python-" name && name <> current then
        Temporary.remove (folder / name))
    (try Sys.readdir folder with Sys_error _ -> [||])

let unix f =
  match f () with
  | () -> Ok ()
  | exception Unix.Unix_error (reason, _, path) ->
      Error (Printf.sprintf "cannot write %s: %s" path (Unix.error_message reason))

let replace folder name =
  let fresh = folder / "python.new" in
  unix (fun () ->
      if Sys.file_exists fresh then Unix.unlink fresh;
      Unix.symlink name fresh;
      Unix.rename fresh (link folder))

let installed folder chosen =
  let name = Printf.sprintf "python-%.0f-%d" (Unix.time ()) (Unix.getpid ()) in
  let path = folder / name in
  let packages =
    List.sort_uniq compare (List.concat_map (fun g -> List.map fst g.packages) chosen)
  in
  Printf.printf "Installing %s in %s\n%!" (String.concat ", " packages) folder;
  let result =
    let* () = make_environment path in
    let* () =
      match
        Process.output (python_of path)
          ([ "-m"; "pip"; "install"; "--quiet"; "--disable-pip-version-check" ] @ packages)
      with
      | Ok _ -> Ok ()
      | Error (Not_found program) -> Error (program ^ " is missing")
      | Error (Failed { errors; _ }) -> Error (refused packages errors)
    in
    let* () = add_own_package path in
    let* () =
      Output.write
        [ (installed_groups path, String.concat "" (List.map (fun g -> g.name ^ "\n") chosen)) ]
    in
    replace folder name
  in
  if Result.is_error result then Temporary.remove path else remove_others folder;
  result

let chosen names =
  let unknown = List.filter (fun name -> of_name name = None) names in
  match unknown with
  | name :: _ ->
      Error
        (Printf.sprintf "there is no group of extras `%s`; the groups are %s"
           (Basis.Printable.name name)
           (Basis.Enumeration.all (List.map (fun g -> "`" ^ g.name ^ "`") groups)))
  | [] ->
      let before =
        Option.fold (environment ()) ~none:[] ~some:(fun e -> read (installed_groups e))
      in
      let all = List.filter (fun g -> List.mem g.name (names @ before)) groups in
      if all = [] then
        Error
          (Printf.sprintf "name the extras to install: %s"
             (Basis.Enumeration.all (List.map (fun g -> "`" ^ g.name ^ "`") groups)))
      else Ok all

let install names =
  Reporting.(
    let* chosen = chosen names in
    let* folder = folder () in
    let* () =
      Result.map_error
        (fun reason -> reason ^ "; set XDG_DATA_HOME to a folder of your own")
        (Output.folder folder)
    in
    let* () = installed folder chosen in
    List.iter (fun g -> Printf.printf "ok  %-8s  %s\n" g.name g.purpose) chosen;
    Exit_status.ok)

(* {1 Listing} *)

let versions python packages =
  let program =
    "import sys\n\
     from importlib.metadata import version\n\
     for name in sys.argv[1:]: print(name, version(name))"
  in
  match Process.output python ("-c" :: program :: packages) with
  | Ok text -> Ok (List.filter (( <> ) "") (String.split_on_char '\n' text))
  | Error _ -> Error ()

let state group =
  let packages = List.map fst group.packages in
  let found python = Result.to_option (versions python packages) in
  let again = Printf.sprintf "`%s`" (command group.name) in
  match List.find_map found (candidates ()) with
  | Some versions -> Ok versions
  | None -> (
      match environment () with
      | Some environment when not (works (python_of environment)) ->
          Error
            (Printf.sprintf "the environment %s is damaged, or its Python was removed: run %s"
               environment again)
      | Some _ | None -> (
          match Sys.getenv_opt "VIRTUAL_ENV" with
          | Some active when active <> "" && not (works (python_of active)) ->
              Error
                (Printf.sprintf
                   "the active virtual environment %s is damaged, or its Python was removed: run \
                    `deactivate`"
                   (Basis.Printable.name active))
          | Some active when active <> "" ->
              Error
                (Printf.sprintf
                   "not installed in the active virtual environment: run `pip install %s`, or run \
                    `deactivate` and then %s"
                   (String.concat " " packages) again)
          | Some _ | None -> Error ("not installed: run " ^ again)))

let list () =
  List.iter
    (fun g ->
      let state =
        match state g with Ok versions -> String.concat ", " versions | Error reason -> reason
      in
      Printf.printf "%-8s  %s\n          %s\n" g.name g.purpose state)
    groups;
  Exit_status.ok
