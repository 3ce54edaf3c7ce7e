let ( / ) = Filename.concat

type finding =
  | Fine of string
  | Missing of string
      (** something that only some commands need is missing; the text names these commands and says
          how to install it *)
  | Broken of string  (** frobc does not work *)

let print name finding =
  let word, text =
    match finding with
    | Fine text -> ("ok  ", text)
    | Missing text -> ("note", text)
    | Broken text -> ("FAIL", text)
  in
  Printf.printf "%s  %-16s %s\n%!" word name text

let first_line text =
  match String.split_on_char '\n' (String.trim text) with line :: _ -> line | [] -> ""

let variable name = match Sys.getenv_opt name with Some "" | None -> None | set -> set
let words text = List.filter (( <> ) "") (String.split_on_char ' ' text)

let has_word word text =
  let n = String.length word in
  let rec from k = k + n <= String.length text && (String.sub text k n = word || from (k + 1)) in
  from 0

let on_path name =
  let folders = String.split_on_char ':' (Option.value (Sys.getenv_opt "PATH") ~default:"") in
  let is_program path =
    match Unix.access path [ X_OK ] with
    | () -> not (Sys.is_directory path)
    | exception (Unix.Unix_error _ | Sys_error _) -> false
  in
  List.filter is_program (List.map (fun folder -> folder / name) folders)

let entries folder =
  match Sys.readdir folder with
  | names ->
      Array.sort compare names;
      List.map (fun name -> folder / name) (Array.to_list names)
  | exception Sys_error _ -> []

(* {1 frobc} *)

let version_of program =
  match Process.output program [ "--version" ] with
  | Ok text -> first_line text
  | Error _ -> "a version that does not start"

let versions () =
  let different =
    List.filter_map
      (fun path ->
        let version = version_of path in
        if version = Version.number then None else Some (Printf.sprintf "%s is %s" path version))
      (on_path "frobc")
  in
  match different with
  | [] -> Fine (Printf.sprintf "%s, %s" Version.number Sys.executable_name)
  | _ ->
      Missing
        (Printf.sprintf
           "this is frobc %s at %s, but the PATH has another version: %s; remove one of them, or \
            put the folder of the one that you want first in the PATH"
           Version.number Sys.executable_name (String.concat ", " different))

let host_fault path = function
  | Process.Not_found _ -> Some (path ^ " is missing: reinstall frobc")
  | Failed { errors; _ } when has_word "GLIBC_" errors ->
      Some
        (Printf.sprintf
           "the C library of this system is older than the one that frobc was built with (%s): use \
            a newer system, or build frobc from its sources with `make`"
           (first_line errors))
  | Failed { errors; _ } when has_word "Exec format error" errors ->
      Some
        (Printf.sprintf
           "%s is for another processor architecture: build frobc from its sources with `make`" path)
  | Failed { errors; _ } when has_word "shared libraries" errors ->
      Some (Printf.sprintf "%s: reinstall frobc" (first_line errors))
  | Failed _ -> None

let installation (r : Resources.t) =
  let hosts = [ r.trace_host; r.simulator; r.viewer; r.server ] in
  let fault path =
    match Process.output path [ "--help" ] with
    | Ok _ -> None
    | Error failure -> host_fault path failure
  in
  match List.find_map fault hosts with
  | Some text -> Broken text
  | None -> (
      match
        List.find_opt
          (fun path -> not (Sys.file_exists path))
          [ r.headers; r.runtime; r.robot_host; r.worlds; r.selftest; r.template; r.python ]
      with
      | Some path -> Broken (path ^ " is missing: reinstall frobc")
      | None -> Fine r.prefix)

let cache () =
  match Cache.is_kept () with
  | Ok folder -> Fine folder
  | Error folder ->
      Missing
        (Printf.sprintf
           "cannot write to %s, so every command compiles from scratch: set XDG_CACHE_HOME to a \
            folder of your own"
           folder)

(* {1 Compilers} *)

let c_compiler () =
  let compiler = (Toolchain.this_machine ()).compiler in
  let shown = Basis.Printable.name compiler in
  match Process.output Sys.executable_name [ "selftest" ] with
  | Ok text when has_word "verdict: fit" text && Tcc.is_own compiler ->
      Fine
        (shown
       ^ ", which comes with frobc, handles generated code correctly; programs with C files need \
          another one: run `sudo apt-get install gcc libc6-dev`")
  | Ok text when has_word "verdict: fit" text -> Fine (shown ^ " handles generated code correctly")
  | Ok text | Error (Failed { errors = text; _ }) ->
      let is_error = String.starts_with ~prefix:"error: " in
      let reason =
        match List.find_opt is_error (String.split_on_char '\n' text) with
        | Some line ->
            let is_introduction = String.ends_with ~suffix:":" line in
            let n = String.length line - 7 - if is_introduction then 1 else 0 in
            " (" ^ String.sub line 7 n ^ ")"
        | None -> ""
      in
      Broken
        (Printf.sprintf
           "%s does not handle generated code correctly%s: set the environment variable CC to \
            another compiler; `frobc selftest` shows the details"
           shown reason)
  | Error (Not_found _) -> Broken (Sys.executable_name ^ " is missing: reinstall frobc")

let cross name ~compiler ~package =
  if on_path compiler <> [] then Fine compiler
  else
    Missing
      (Printf.sprintf "for `frobc build --target %s`: run `sudo apt-get install %s`" name package)

(* {1 Libraries and programs that some commands load} *)

let library_folders =
  [
    "/usr/lib/x86_64-linux-gnu";
    "/usr/lib/aarch64-linux-gnu";
    "/usr/lib64";
    "/usr/lib";
    "/usr/local/lib";
  ]

let library name ~purpose ~package =
  match List.find_opt (fun folder -> Sys.file_exists (folder / name)) library_folders with
  | Some folder -> Fine (folder / name)
  | None -> Missing (Printf.sprintf "for %s: run `sudo apt-get install %s`" purpose package)

let program name ~purpose ~package =
  match on_path name with
  | path :: _ -> Fine path
  | [] -> Missing (Printf.sprintf "for %s: run `sudo apt-get install %s`" purpose package)

let fonts () =
  if
    List.exists Sys.file_exists
      [ "/usr/share/fonts/truetype"; "/usr/share/fonts/opentype"; "/usr/share/fonts/TTF" ]
  then Fine "/usr/share/fonts"
  else Missing "for text in pictures: run `sudo apt-get install fonts-dejavu-core fontconfig`"

(* {1 Python} *)

let python () =
  let install = "run `sudo apt-get install python3-venv`" in
  match
    Process.output "python3"
      [ "-c"; "import sys, venv, ensurepip; print('%d.%d' % sys.version_info[:2])" ]
  with
  | Ok version
    when compare
           (List.map int_of_string_opt (String.split_on_char '.' (String.trim version)))
           [ Some 3; Some 9 ]
         < 0 ->
      Missing
        (Printf.sprintf "Python %s is too old for the package frob, which needs 3.9 or later"
           (String.trim version))
  | Ok version -> Fine ("Python " ^ String.trim version)
  | Error (Not_found _) -> Missing ("for `frobc falsify` and notebooks: " ^ install)
  | Error (Failed _) ->
      Missing ("python3 has no module venv, which `frobc extras` needs: " ^ install)

let extras (g : Extras.group) =
  match Extras.state g with
  | Ok versions -> Fine (String.concat ", " versions)
  | Error reason -> Missing (Printf.sprintf "for %s: %s" g.purpose reason)

(* {1 Desktop and robots} *)

let browser () =
  let is_desktop = variable "DISPLAY" <> None || variable "WAYLAND_DISPLAY" <> None in
  if not is_desktop then
    Missing
      "there is no desktop: `frobc view` prints the address of the page; on another computer, type \
       `ssh -L PORT:127.0.0.1:PORT THIS_COMPUTER` and open that address"
  else program "xdg-open" ~purpose:"opening the page of `frobc view`" ~package:"xdg-utils"

let is_serial path =
  let name = Filename.basename path in
  List.exists (fun prefix -> String.starts_with ~prefix name) [ "ttyUSB"; "ttyACM"; "rfcomm" ]

let serial () =
  let ports = List.filter is_serial (entries "/dev") in
  let is_open path =
    match Unix.access path [ R_OK; W_OK ] with () -> true | exception Unix.Unix_error _ -> false
  in
  match (ports, List.filter (fun path -> not (is_open path)) ports) with
  | [], _ -> Missing "no robot is connected to a serial port (/dev/ttyUSB*, /dev/ttyACM*)"
  | _, [] -> Fine (String.concat ", " ports)
  | _, refused ->
      let user = Option.value (variable "USER") ~default:"$USER" in
      Missing
        (Printf.sprintf
           "you do not have permission to open %s: run `sudo usermod -aG dialout %s`, then log out \
            and in again"
           (String.concat ", " refused) (Basis.Printable.name user))

let boot_loaders () =
  let mounted =
    match Resolve.Files.on_disk.read "/proc/mounts" with
    | Ok text ->
        List.filter_map
          (fun line -> match words line with _ :: folder :: _ -> Some folder | _ -> None)
          (String.split_on_char '\n' text)
    | Error _ -> []
  in
  match List.filter (fun folder -> Sys.file_exists (folder / "INFO_UF2.TXT")) mounted with
  | [] ->
      Missing
        "no boot-loader drive is mounted: hold down the board's BOOT button while you connect the \
         board"
  | drives -> Fine (String.concat ", " drives)

let ros () =
  match (variable "ROS_DISTRO", variable "AMENT_PREFIX_PATH") with
  | Some name, _ -> Fine (Basis.Printable.name name)
  | None, Some _ -> Fine "an unnamed distribution (AMENT_PREFIX_PATH)"
  | None, None -> (
      match entries "/opt/ros" with
      | setup :: _ ->
          Missing (Printf.sprintf "ROS is not set up in this terminal: run `. %s/setup.sh`" setup)
      | [] -> Missing "ROS 2 is not installed; only `--ros2` and `frobc serve --robot ros` need it")

(* {1 The command} *)

let looks (resources : Resources.t) =
  [
    ("frobc", versions);
    ("installation", fun () -> installation resources);
    ("C compiler", c_compiler);
    ("cache", cache);
    ("Python", python);
  ]
  @ List.map (fun (g : Extras.group) -> ("extras " ^ g.name, fun () -> extras g)) Extras.groups
  @ [
      ("browser", browser);
      ("fonts", fonts);
      ( "AprilTags",
        fun () ->
          library "libapriltag.so.3" ~purpose:"programs that detect tags" ~package:"libapriltag-dev"
      );
      ( "JPEG",
        fun () ->
          library "libturbojpeg.so.0" ~purpose:"cameras that send JPEG" ~package:"libturbojpeg0" );
      ("gzip", fun () -> program "gzip" ~purpose:"recordings named .gz" ~package:"gzip");
      ("zstd", fun () -> program "zstd" ~purpose:"recordings named .zst" ~package:"zstd");
      ("serial ports", serial);
      ( "aarch64",
        fun () ->
          cross "aarch64-linux" ~compiler:"aarch64-linux-gnu-gcc"
            ~package:"gcc-aarch64-linux-gnu libc6-dev-arm64-cross" );
      ( "Cortex-M",
        fun () ->
          cross "cortex-m" ~compiler:"arm-none-eabi-gcc"
            ~package:"gcc-arm-none-eabi libnewlib-arm-none-eabi" );
      ("boot loader", boot_loaders);
      ("ROS", ros);
    ]

let run () =
  Reporting.(
    let* resources = Installation.find () in
    let found =
      List.map
        (fun (name, look) ->
          let finding = look () in
          print name finding;
          finding)
        (looks resources)
    in
    let is_broken = List.exists (function Broken _ -> true | Fine _ | Missing _ -> false) found in
    if is_broken then Exit_status.rejected else Exit_status.ok)
