let files = { Resolve.Files.on_disk with parsed = Prepared.Library.tree }

let modules ~library file =
  let sink = Basis.Diagnostic.sink () and remember ~file:_ _ = () in
  let modules = Resolve.Modules.load sink ~files ~remember ~library file in
  let path (m : Resolve.Modules.t) =
    if m.library then Filename.concat library (m.name ^ ".frob") else m.file
  in
  let from_library, own = List.partition (fun (m : Resolve.Modules.t) -> m.library) modules in
  (List.rev_map path own, List.rev_map path from_library)

(* What takes files of another kind, by the ending of their names. *)
let of_another_kind file =
  match String.lowercase_ascii (Filename.extension (Packed.stem file)) with
  | ".toml" ->
      Some
        ( "a world",
          Printf.sprintf "it goes beside a program: `frobc run PROGRAM.frob --world %s`" file )
  | ".csv" ->
      Some
        ( "a table of inputs, or a recording",
          Printf.sprintf "it goes beside a program: `frobc trace PROGRAM.frob --input %s`" file )
  | ".mcap" -> Some ("a recording as MCAP", Printf.sprintf "`frobc convert %s RUN.csv`" file)
  | ".c" | ".cc" | ".cpp" | ".cxx" | ".o" | ".a" | ".so" ->
      Some
        ( "C or C++",
          Printf.sprintf "what a program calls of it goes beside the program: `--with %s`" file )
  | ".h" | ".hpp" ->
      Some
        ( "a C header",
          Printf.sprintf "a program that calls C names it: `foreign include \"%s\"`"
            (Filename.basename file) )
  | _ -> None

let programs_in folder =
  match Sys.readdir folder with
  | exception Sys_error _ -> []
  | files ->
      let is_program file = Filename.check_suffix file ".frob" in
      List.sort String.compare (List.filter is_program (Array.to_list files))

let of_a_folder folder =
  match programs_in folder with
  | [ one ] -> Printf.sprintf "; did you mean %s?" (Filename.concat folder one)
  | [] -> ""
  | first :: _ -> Printf.sprintf "; name a program in it, such as %s" (Filename.concat folder first)

(* No text has a byte 0; programs that compilers made have one soon. *)
let is_binary text = String.contains (String.sub text 0 (min 512 (String.length text))) '\000'

let check file =
  match (Resolve.Files.on_disk.read file, of_another_kind file) with
  | Error Missing, _ ->
      let program = file ^ ".frob" in
      let hint = if Sys.file_exists program then "; did you mean " ^ program ^ "?" else "" in
      Error (Printf.sprintf "there is no file %s%s" file hint)
  | Error (Unreadable reason), _ ->
      let hint = if Sys.file_exists file && Sys.is_directory file then of_a_folder file else "" in
      Error (Printf.sprintf "cannot read %s: %s%s" file reason hint)
  | Ok _, Some (kind, use) ->
      Error (Printf.sprintf "%s is no Frob program but %s; %s" file kind use)
  | Ok text, None when is_binary text && not (Filename.check_suffix file ".frob") ->
      Error (Printf.sprintf "%s is no Frob program: it is no text" file)
  | Ok _, None -> Ok ()

let rec all_exist = function
  | [] -> Ok ()
  | file :: _ when not (Sys.file_exists file) -> Error (Printf.sprintf "there is no file %s" file)
  | _ :: others -> all_exist others
