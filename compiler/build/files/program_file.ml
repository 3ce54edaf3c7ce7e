let files = { Resolve.Files.on_disk with parsed = Prepared.Library.tree }

let modules ~library file =
  let context = Resolve.Context.create (Basis.Facts.ignored ()) and remember ~file:_ _ = () in
  let modules = Resolve.Modules.load context ~files ~remember ~library file in
  let path (m : Resolve.Modules.t) =
    if m.library then Filename.concat library (m.name ^ ".frob") else m.file
  in
  let from_library, own = List.partition (fun (m : Resolve.Modules.t) -> m.library) modules in
  (List.rev_map path own, List.rev_map path from_library)

(* Describes a file that is not a program: its kind, according to its extension, and the command
   that reads it. *)
let of_another_kind file =
  let word = Basis.Printable.path file in
  match String.lowercase_ascii (Filename.extension (Packed.stem file)) with
  | ".toml" ->
      Some
        ("a world", Printf.sprintf "use it with a program: `frobc run PROGRAM.frob --world %s`" word)
  | ".csv" ->
      Some
        ( "a table of inputs, or a recording",
          Printf.sprintf "use it with a program: `frobc trace PROGRAM.frob --input %s`" word )
  | ".mcap" ->
      Some ("an MCAP recording", Printf.sprintf "convert it: `frobc convert %s RUN.csv`" word)
  | ".c" | ".cc" | ".cpp" | ".cxx" | ".o" | ".a" | ".so" ->
      Some ("C or C++", Printf.sprintf "use it with a program that calls it: `--with %s`" word)
  | ".h" | ".hpp" ->
      Some
        ( "a C header",
          Printf.sprintf
            "include it in a program with `foreign include \"%s\"`, and allow it on the command \
             line with `--with %s`"
            (Filename.basename file) word )
  | _ -> None

let programs_in folder =
  match Sys.readdir folder with
  | exception Sys_error _ -> []
  | files ->
      let is_program file = Filename.check_suffix file ".frob" in
      List.sort String.compare (List.filter is_program (Array.to_list files))

let of_a_folder folder =
  match programs_in folder with
  | [ one ] ->
      Printf.sprintf "; did you mean %s?" (Basis.Printable.path (Filename.concat folder one))
  | [] -> ""
  | first :: _ ->
      Printf.sprintf "; choose a program in it, such as %s"
        (Basis.Printable.path (Filename.concat folder first))

(* Text files contain no zero bytes, but executables have one near the start. *)
let is_binary text = String.contains (String.sub text 0 (min 512 (String.length text))) '\000'

let check file =
  match (Resolve.Files.on_disk.read file, of_another_kind file) with
  | Error Missing, _ ->
      let program = file ^ ".frob" in
      let hint =
        if Sys.file_exists program then "; did you mean " ^ Basis.Printable.path program ^ "?"
        else ""
      in
      Error (Printf.sprintf "there is no file %s%s" (Basis.Printable.name file) hint)
  | Error (Unreadable reason), _ ->
      let hint = if Sys.file_exists file && Sys.is_directory file then of_a_folder file else "" in
      Error (Printf.sprintf "cannot read %s: %s%s" (Basis.Printable.name file) reason hint)
  | Ok _, Some (kind, use) ->
      Error (Printf.sprintf "%s is not a Frob program but %s; %s" file kind use)
  | Ok text, None when is_binary text && not (Filename.check_suffix file ".frob") ->
      Error (Printf.sprintf "%s is not a Frob program: it is not a text file" file)
  | Ok _, None -> Ok ()

let with_tests files =
  let add found file = if List.mem file found then found else file :: found in
  let add_both found file =
    let tests = Resolve.Test_file.path file in
    let found = add found file in
    if Resolve.Test_file.program file = None && Sys.file_exists tests then add found tests
    else found
  in
  List.rev (List.fold_left add_both [] files)

let rec all_exist = function
  | [] -> Ok ()
  | file :: _ when not (Sys.file_exists file) ->
      Error (Printf.sprintf "there is no file %s" (Basis.Printable.name file))
  | _ :: others -> all_exist others
