let ( / ) = Filename.concat

(* All or the first error. *)
let rec all = function
  | [] -> Ok []
  | x :: others -> Result.bind x (fun x -> Result.map (List.cons x) (all others))

let files folder =
  let names = Sys.readdir folder in
  Array.sort compare names;
  List.filter (fun name -> not (Sys.is_directory (folder / name))) (Array.to_list names)

(* The files of a folder, not those of the folders in it, and where they go. *)
let copies_of source target =
  let one name =
    Result.map (fun text -> (target / name, text)) (Own_headers.read (source / name))
  in
  all (List.map one (files source))

let manifest name =
  Printf.sprintf
    {|{
  "name": "%s",
  "version": "0.1.0",
  "description": "The Frob program %s, with the runtime that drives its robot",
  "frameworks": "*",
  "platforms": "*",
  "headers": "%s.h",
  "build": {
    "flags": ["-ffp-contract=off"]
  }
}
|}
    name name name

(* What of the runtime a board needs: everything but ports and other hosts. *)
let runtime_folders (resources : Resources.t) =
  let runtime = resources.runtime_sources in
  let drivers = Sys.readdir (runtime / "drivers") in
  Array.sort compare drivers;
  let robots =
    List.filter (fun name -> Sys.is_directory (runtime / "drivers" / name)) (Array.to_list drivers)
  in
  [ (resources.headers / "frob", "frob"); (resources.elementary, "elementary") ]
  @ List.map
      (fun folder -> (runtime / folder, folder))
      ([ "core"; "hal"; "drivers"; "hosts/board" ] @ List.map (fun r -> "drivers" / r) robots)

(* What the user's C and its headers include; a generated file is newer than what an
   earlier run may have left beside them. *)
let headers_of ~sources ~foreign_folders generated =
  let ( let* ) = Result.bind in
  let* of_sources = Own_headers.of_sources sources in
  let* of_program =
    Own_headers.of_text ~folders:foreign_folders (String.concat "\n" (List.map snd generated))
  in
  let is_own (h : Own_headers.t) = not (List.mem_assoc h.name generated) in
  Ok (List.filter is_own (of_sources @ of_program))

(* A folder is the export's own: new, empty, or one that an export has made. *)
let is_ours ~folder ~name =
  (not (Sys.file_exists folder))
  || Sys.is_directory folder
     && (Sys.readdir folder = [||]
        || Own_headers.read (folder / "library.json") = Ok (manifest name))

let write_library (resources : Resources.t) ~folder ~name ~sources ~foreign_folders generated =
  let ( let* ) = Result.bind in
  let source = folder / "src" in
  let* () =
    if is_ours ~folder ~name then Ok ()
    else
      Error
        (Printf.sprintf
           "%s is there already, and is no export of %s: move it away, or name another folder"
           folder name)
  in
  let copy from target = Result.map (fun text -> (target, text)) (Own_headers.read from) in
  let* own = all (List.map (fun file -> copy file (source / Filename.basename file)) sources) in
  let* headers = headers_of ~sources ~foreign_folders generated in
  let* headers =
    all (List.map (fun (h : Own_headers.t) -> copy h.path (source / h.name)) headers)
  in
  let* runtime =
    all (List.map (fun (from, into) -> copies_of from (source / into)) (runtime_folders resources))
  in
  let* example =
    copies_of (resources.runtime_sources / "hosts" / "arduino") (folder / "examples" / name)
  in
  let generated = List.map (fun (file, text) -> (source / file, text)) generated in
  let files =
    ((folder / "library.json", manifest name) :: generated)
    @ own @ headers @ List.concat runtime @ example
  in
  let* _ = all (List.map (fun (path, _) -> Output.folder (Filename.dirname path)) files) in
  Output.write files

let platformio (general : General.t) ~entry ~sources ~folder file =
  let ( let* ) = General.( let* ) in
  let* resources = Resources.find () in
  let* () = Program_file.all_exist sources in
  Compiled.to_c general resources ~entry file (fun (files : Cgen.Emit.t) ->
      let name = C_file.name file in
      let* () = Built.for_robot ~name ~sees:false files in
      let* table = Built.host_table ~entry files in
      let generated =
        [
          (name ^ ".h", files.header);
          (name ^ ".c", files.source);
          (name ^ "_host.c", table);
          Target.state_of name;
          Target.own_driver ~name (Robots.own_of general.robot);
        ]
        @ Option.to_list files.robot_header
      in
      let* () =
        write_library resources ~folder ~name ~sources ~foreign_folders:files.foreign.folders
          generated
      in
      Exit_status.ok)
