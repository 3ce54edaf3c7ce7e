let ( / ) = Filename.concat

(* All results, or the first error. *)
let rec all = function
  | [] -> Ok []
  | x :: others -> Result.bind x (fun x -> Result.map (List.cons x) (all others))

let files folder =
  let names = Sys.readdir folder in
  Array.sort compare names;
  List.filter (fun name -> not (Sys.is_directory (folder / name))) (Array.to_list names)

let copies_of source target =
  let one name =
    Result.map (fun text -> (target / name, text)) (Own_headers.read (source / name))
  in
  all (List.map one (files source))

(* PlatformIO requires the version number of the user's library (not that of Frob), which frobc does
   not know. *)
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

(* The parts of the runtime that a board needs: everything except ports and other hosts. *)
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

(* The headers that the user's C and the generated C include. Excludes generated headers, because an
   earlier run may have left an older copy next to the sources. *)
let headers_of ~sources ~folders generated =
  let open Basis.Let_syntax.Result in
  let* of_sources = Own_headers.of_sources sources in
  let* of_program = Own_headers.of_text ~folders (String.concat "\n" (List.map snd generated)) in
  let is_own (h : Own_headers.t) = not (List.mem_assoc h.name generated) in
  Ok (List.filter is_own (of_sources @ of_program))

(* Copies of the user's files. Each file is given by its path and by its name in the export, which
   puts all of them in one folder. *)
let copies_of_own ~into files =
  let open Basis.Let_syntax.Result in
  let add copies (path, name) =
    let* copies = copies in
    let* text = Own_headers.read path in
    match List.find_opt (fun (_, other, _) -> String.equal other name) copies with
    | None -> Ok ((path, name, text) :: copies)
    | Some (_, _, same) when String.equal same text -> Ok copies
    | Some (other, _, _) ->
        let shown = Basis.Printable.name in
        Error
          (Printf.sprintf
             "%s and %s have the same name, but an export puts both into one folder: rename one of \
              them"
             (shown other) (shown path))
  in
  let* copies = List.fold_left add (Ok []) files in
  Ok (List.rev_map (fun (_, name, text) -> (into / name, text)) copies)

let own_files ~into ~sources ~folders generated =
  let open Basis.Let_syntax.Result in
  let* headers = headers_of ~sources ~folders generated in
  copies_of_own ~into
    (List.map (fun file -> (file, Filename.basename file)) sources
    @ List.map (fun (h : Own_headers.t) -> (h.path, h.name)) headers)

(* Whether the export may write to the folder. The folder must be new, empty, or the result of an
   earlier export. *)
let is_ours ~folder ~name =
  (not (Sys.file_exists folder))
  || Sys.is_directory folder
     && (Sys.readdir folder = [||]
        || Own_headers.read (folder / "library.json") = Ok (manifest name))

let write_library (resources : Resources.t) ~folder ~name ~sources ~folders generated =
  let open Basis.Let_syntax.Result in
  let source = folder / "src" in
  let* () =
    if is_ours ~folder ~name then Ok ()
    else
      Error
        (Printf.sprintf
           "%s already exists and is not an export of %s: move it away, or use another folder"
           folder name)
  in
  let* own = own_files ~into:source ~sources ~folders generated in
  let* runtime =
    all (List.map (fun (from, into) -> copies_of from (source / into)) (runtime_folders resources))
  in
  let* example =
    copies_of (resources.runtime_sources / "hosts" / "arduino") (folder / "examples" / name)
  in
  let generated = List.map (fun (file, text) -> (source / file, text)) generated in
  let files =
    ((folder / "library.json", manifest name) :: generated) @ own @ List.concat runtime @ example
  in
  let* _ = all (List.map (fun (path, _) -> Output.folder (Filename.dirname path)) files) in
  Output.write files

let platformio (general : Common_options.t) ~entry ~sources ~folder file =
  let ( let* ) = Reporting.( let* ) in
  let* resources = Installation.find () in
  let* () = Program_file.all_exist sources in
  Compiled.to_c ~banner:true general resources ~entry file (fun (files : Cgen.Emit.t) ->
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
      let* foreign = Foreign_files.checked ~name ~sources files in
      let { Toolchain.sources; folders; allowed = _ } =
        Option.value foreign ~default:{ Toolchain.sources = []; folders = []; allowed = [] }
      in
      let* () = write_library resources ~folder ~name ~sources ~folders generated in
      Exit_status.ok)
