type t = { options : string list; libraries : string list }

let ( / ) = Filename.concat
let variable = "AMENT_PREFIX_PATH"
let tried = [ ("9.2.", "Jazzy"); ("10.1.", "Kilted") ]

(* The packages that the host uses, and the libraries that it is linked with. The host loads the
   libraries of the other packages when a program needs them. *)
let needed =
  [
    ("rcl", [ "rcl" ]);
    ("rcl_lifecycle", []);
    ("rcl_yaml_param_parser", [ "rcl_yaml_param_parser" ]);
    ("rmw", [ "rmw" ]);
    ("rcutils", [ "rcutils" ]);
    ("rosidl_runtime_c", [ "rosidl_runtime_c" ]);
    ("geometry_msgs", [ "geometry_msgs__rosidl_typesupport_c"; "geometry_msgs__rosidl_generator_c" ]);
    ("nav_msgs", [ "nav_msgs__rosidl_typesupport_c"; "nav_msgs__rosidl_generator_c" ]);
    ("sensor_msgs", [ "sensor_msgs__rosidl_typesupport_c"; "sensor_msgs__rosidl_generator_c" ]);
    ("diagnostic_msgs", []);
    ("std_msgs", [ "std_msgs__rosidl_typesupport_c"; "std_msgs__rosidl_generator_c" ]);
    ("visualization_msgs", []);
    ("lifecycle_msgs", []);
    ("rosgraph_msgs", [ "rosgraph_msgs__rosidl_typesupport_c"; "rosgraph_msgs__rosidl_generator_c" ]);
    ( "rcl_interfaces",
      [ "rcl_interfaces__rosidl_typesupport_c"; "rcl_interfaces__rosidl_generator_c" ] );
  ]

(* Packages whose headers are included by the headers of the needed packages. Some distributions
   lack some of these packages. *)
let included =
  [
    "builtin_interfaces";
    "rosidl_dynamic_typesupport";
    "rosidl_typesupport_introspection_c";
    "rosidl_typesupport_interface";
    "service_msgs";
    "tracetools";
    "type_description_interfaces";
  ]

let prefixes () =
  List.filter
    (fun prefix -> prefix <> "")
    (String.split_on_char ':' (Option.value (Sys.getenv_opt variable) ~default:""))

(* The first prefix that contains this package. *)
let prefix_of prefixes package =
  List.find_opt
    (fun prefix ->
      Sys.file_exists (prefix / "share" / "ament_index" / "resource_index" / "packages" / package))
    prefixes

let headers prefixes package =
  match prefix_of prefixes package with
  | Some prefix when Sys.file_exists (prefix / "include" / package) ->
      [ "-isystem"; prefix / "include" / package ]
  | Some _ | None -> []

(* The setup scripts of the ROS 2 installations in /opt/ros. *)
let setups () =
  let folder = "/opt/ros" in
  let names = if Sys.file_exists folder then Sys.readdir folder else [||] in
  Array.sort compare names;
  List.filter Sys.file_exists
    (List.map (fun name -> folder / name / "setup.bash") (Array.to_list names))

let not_found () =
  match setups () with
  | [] ->
      "there is no ROS 2 in this shell: install it, and source its setup script, as in `source \
       /opt/ros/jazzy/setup.bash`, which sets AMENT_PREFIX_PATH"
  | scripts ->
      Printf.sprintf "there is no ROS 2 in this shell: run %s first"
        (Basis.Enumeration.one_of
           (List.map (fun script -> "`source " ^ Basis.Printable.name script ^ "`") scripts))

let distribution () = Option.value (Sys.getenv_opt "ROS_DISTRO") ~default:"DISTRO"

let lacks packages =
  let debian package =
    Printf.sprintf "ros-%s-%s"
      (Basis.Printable.word (distribution ()))
      (String.concat "-" (String.split_on_char '_' package))
  in
  Printf.sprintf
    "ROS 2 in this shell (AMENT_PREFIX_PATH) lacks the %s %s: install %s, as in `sudo apt install \
     %s`"
    (match packages with [ _ ] -> "package" | _ -> "packages")
    (Basis.Enumeration.all packages)
    (match packages with [ _ ] -> "it" | _ -> "them")
    (String.concat " " (List.map debian packages))

let found prefixes =
  let folders = List.filter_map (fun (package, _) -> prefix_of prefixes package) needed in
  let libraries =
    List.concat_map
      (fun (package, names) ->
        let prefix = Option.get (prefix_of prefixes package) in
        List.map (fun name -> prefix / "lib" / ("lib" ^ name ^ ".so")) names)
      needed
  in
  match List.filter (fun library -> not (Sys.file_exists library)) libraries with
  | [] ->
      let search = List.sort_uniq compare (List.map (fun prefix -> prefix / "lib") folders) in
      Ok
        {
          options =
            (* Unlike a runpath, an rpath also applies to transitive dependencies. *)
            [
              "-pthread"; "-D_GNU_SOURCE"; "-Wl,--disable-new-dtags"; "-Wl,--allow-shlib-undefined";
            ]
            @ List.concat_map (fun folder -> [ "-Wl,-rpath," ^ folder ]) search
            @ List.concat_map (headers prefixes) (List.map fst needed @ included);
          libraries;
        }
  | library :: _ ->
      Error
        (Printf.sprintf "ROS 2 in this shell is incomplete: there is no %s; install ROS 2 again"
           (Basis.Printable.name library))

let find () =
  let prefixes = prefixes () in
  let is_missing (package, _) = prefix_of prefixes package = None in
  match List.filter is_missing needed with
  | missing when List.mem_assoc "rcl" missing -> Error (not_found ())
  | [] -> found prefixes
  | missing -> Error (lacks (List.map fst missing))

(* The version in the package's manifest: <version>9.2.8</version>. *)
let version_of prefix package =
  let file = prefix / "share" / package / "package.xml" in
  match Own_headers.read file with
  | Error _ -> None
  | Ok text -> (
      let tag = Str.regexp "<version>[ \t\n]*\\([0-9.]+\\)" in
      match Str.search_forward tag text 0 with
      | _ -> Some (Str.matched_group 1 text)
      | exception Not_found -> None)

let untried () =
  let ( let* ) = Option.bind in
  let* prefix = prefix_of (prefixes ()) "rcl" in
  let* version = version_of prefix "rcl" in
  if List.exists (fun (start, _) -> String.starts_with ~prefix:start version) tried then None
  else
    Some
      (Printf.sprintf
         "frobc is tested with ROS 2 %s, but not with the installation in this shell, which has \
          rcl %s"
         (Basis.Enumeration.all (List.map snd tried))
         version)
