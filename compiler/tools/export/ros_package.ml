open Basis.Let_syntax.Result

let ( / ) = Filename.concat

(* Package names must be in lower case. *)
let package_of name = String.lowercase_ascii name

let dependencies =
  [
    "diagnostic_msgs";
    "geometry_msgs";
    "lifecycle_msgs";
    "nav_msgs";
    "rcl";
    "rcl_interfaces";
    "rcl_lifecycle";
    "rcl_yaml_param_parser";
    "rcutils";
    "rmw";
    "rosgraph_msgs";
    "rosidl_runtime_c";
    "rosidl_typesupport_introspection_c";
    "sensor_msgs";
    "std_msgs";
    "visualization_msgs";
  ]

(* Packages whose libraries the node loads itself, if the program needs them. *)
let loaded_late = [ "diagnostic_msgs"; "lifecycle_msgs"; "rcl_lifecycle"; "visualization_msgs" ]

let is_of_messages package =
  String.ends_with ~suffix:"_msgs" package || String.ends_with ~suffix:"_interfaces" package

let lines ?(packages = dependencies) one = String.concat "\n" (List.map one packages)

(* The packages that define the messages of the program's own topics. The node loads the libraries
   of these packages when it starts. *)
let own_packages (node : Cgen.Node_table.t option) =
  let package (t : Cgen.Node_table.topic) = List.hd (String.split_on_char '/' t.type_) in
  match node with
  | None -> []
  | Some { inputs; outputs; rate = _ } ->
      List.sort_uniq compare (List.map package (inputs @ outputs))
      |> List.filter (fun package -> not (List.mem package dependencies))

let topics (node : Cgen.Node_table.t option) =
  let name (t : Cgen.Node_table.topic) = t.name in
  match node with
  | None -> [ "odom"; "scan"; "cmd_vel" ]
  | Some { inputs; outputs; rate = _ } -> List.sort_uniq compare (List.map name (inputs @ outputs))

let description name node =
  Printf.sprintf
    {|<?xml version="1.0"?>
<package format="3">
  <name>%s</name>
  <version>0.1.0</version>
  <description>The Frob program %s as a ROS 2 node</description>
  <maintainer email="you@example.com">you</maintainer>
  <!-- The license of the runtime; add the license of your program. -->
  <license>MIT</license>

  <buildtool_depend>ament_cmake</buildtool_depend>
%s
%s  <exec_depend>ros2launch</exec_depend>

  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
|}
    (package_of name) name
    (lines (Printf.sprintf "  <depend>%s</depend>"))
    (String.concat ""
       (List.map (Printf.sprintf "  <exec_depend>%s</exec_depend>\n") (own_packages node)))

(* The targets of a package with messages also include libraries for C++ and Python. *)
let libraries package =
  if is_of_messages package then
    Printf.sprintf "  %s::%s__rosidl_generator_c\n  %s::%s__rosidl_typesupport_c" package package
      package package
  else Printf.sprintf "  %s::%s" package package

let headers package =
  let target = if is_of_messages package then package ^ "__rosidl_generator_c" else package in
  Printf.sprintf "  $<TARGET_PROPERTY:%s::%s,INTERFACE_INCLUDE_DIRECTORIES>" package target

let build_file name =
  Printf.sprintf
    {|cmake_minimum_required(VERSION 3.8)
project(%s C)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_package(ament_cmake REQUIRED)
%s

file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.c)
add_executable(${PROJECT_NAME} ${sources})
target_include_directories(${PROJECT_NAME} PRIVATE src
  # The node loads the libraries of these packages when it needs them.
%s)
target_compile_definitions(${PROJECT_NAME} PRIVATE _GNU_SOURCE)
# Other options change the results of floating-point operations.
target_compile_options(${PROJECT_NAME} PRIVATE -std=gnu11 -ffp-contract=off -fno-strict-aliasing)
target_link_libraries(${PROJECT_NAME}
%s
  ${CMAKE_DL_LIBS} m pthread)

install(TARGETS ${PROJECT_NAME} DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
ament_package()
|}
    (package_of name)
    (lines (Printf.sprintf "find_package(%s REQUIRED)"))
    (lines ~packages:loaded_late headers)
    (lines
       ~packages:(List.filter (fun package -> not (List.mem package loaded_late)) dependencies)
       libraries)

let launch_file name node =
  Printf.sprintf
    {|from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(
            package="%s",
            executable="%s",
            parameters=[{"use_sim_time": False}],
            remappings=[%s],
        )
    ])
|}
    (package_of name) (package_of name)
    (String.concat ", "
       (List.map (fun topic -> Printf.sprintf "(\"%s\", \"%s\")" topic topic) (topics node)))

(* The parts of the runtime that a node needs. A node needs only the headers of the drivers, because
   the driver of the robot `ros` is in hosts/ros. *)
let runtime_files (resources : Resources.t) source =
  let runtime = resources.runtime_sources in
  let only keep folder =
    let* files = Export.copies_of (runtime / folder) (source / folder) in
    Ok (List.filter (fun (path, _) -> keep (Filename.basename path)) files)
  in
  let every _ = true in
  let is_header name = Filename.check_suffix name ".h" in
  (* Excludes the main program for serial lines and its table of drivers. *)
  let is_for_nodes name = not (List.mem name [ "main.c"; "drivers.c"; "drivers.h" ]) in
  let folders =
    [
      ("core", every);
      ("hal", is_header);
      ("hal" / "posix", every);
      ("drivers", is_header);
      ("vision", every);
      ("hosts" / "common", every);
      ("hosts" / "camera", every);
      ("hosts" / "robot", is_for_nodes);
      ("hosts" / "ros", every);
    ]
  in
  let add files folder =
    let* files = files in
    let* more = folder in
    Ok (files @ more)
  in
  List.fold_left add (Ok [])
    (List.map (fun (folder, keep) -> only keep folder) folders
    @ [
        Export.copies_of (resources.headers / "frob") (source / "frob");
        Export.copies_of resources.elementary (source / "elementary");
      ])

(* Whether the export may write to the folder. The folder must be new, empty, or the result of an
   earlier export. *)
let is_ours ~folder ~name =
  (not (Sys.file_exists folder))
  || Sys.is_directory folder
     && (Sys.readdir folder = [||] || Sys.file_exists (folder / "src" / (name ^ "_host.c")))

let write (resources : Resources.t) ~folder ~name ~node ~sources ~folders generated =
  let source = folder / "src" in
  let* () =
    if is_ours ~folder ~name then Ok ()
    else
      Error
        (Printf.sprintf
           "%s already exists and is not an export of %s: move it away, or use another folder"
           (Basis.Printable.name folder) name)
  in
  let* own = Export.own_files ~into:source ~sources ~folders generated in
  let* runtime = runtime_files resources source in
  let generated = List.map (fun (file, text) -> (source / file, text)) generated in
  let edited =
    List.filter
      (fun (path, _) -> not (Sys.file_exists path))
      [
        (folder / "package.xml", description name node);
        (folder / "CMakeLists.txt", build_file name);
        (folder / "launch" / (package_of name ^ ".launch.py"), launch_file name node);
      ]
  in
  let files = edited @ generated @ own @ runtime in
  let* () =
    List.fold_left
      (fun result (path, _) ->
        let* () = result in
        Result.map ignore (Output.folder (Filename.dirname path)))
      (Ok ()) files
  in
  Output.write files

let for_ros (general : Common_options.t) =
  match general.robot with
  | None | Some "ros" -> Ok { general with robot = Some "ros" }
  | Some other ->
      Error
        (Printf.sprintf "--ros2 is for the robot `ros`, not for `%s`: remove --robot"
           (Basis.Printable.name other))

let export general ~entry ~sources ~folder file =
  let ( let* ) = Reporting.( let* ) in
  let* general = for_ros general in
  let* resources = Installation.find () in
  let* () = Program_file.all_exist sources in
  Compiled.to_c ~banner:true general resources ~entry file (fun (files : Cgen.Emit.t) ->
      let name = C_file.name file in
      let* () = Built.for_robot ~name ~sees:true ~ros2:true files in
      let* table = Built.host_table ~entry files in
      let generated =
        [ (name ^ ".h", files.header); (name ^ ".c", files.source); (name ^ "_host.c", table) ]
        @ Option.to_list files.robot_header
      in
      let* foreign = Foreign_files.checked ~name ~sources files in
      let { Toolchain.sources; folders; allowed = _ } =
        Option.value foreign ~default:{ Toolchain.sources = []; folders = []; allowed = [] }
      in
      let* () = write resources ~folder ~name ~node:files.node ~sources ~folders generated in
      Exit_status.ok)
