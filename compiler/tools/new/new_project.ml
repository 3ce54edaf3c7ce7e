let ( / ) = Filename.concat

open Basis.Let_syntax.Result

(* {1 Names} *)

let is_letter c = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
let is_inner c = is_letter c || (c >= '0' && c <= '9') || c = '_' || c = '-'
let is_name name = name <> "" && is_letter name.[0] && String.for_all is_inner name

(* Suggests a valid name that resembles the given one, if possible. *)
let suggestion name =
  let stem = Filename.remove_extension name in
  let meant = if Filename.check_suffix name ".frob" then stem else name in
  let meant = String.map (fun c -> if is_inner c || c >= '\128' then c else '_') meant in
  if is_name meant then Printf.sprintf ", such as %s" meant else ""

let check_name (resources : Resources.t) name =
  if not (is_name name) then
    Error
      (Printf.sprintf
         "`%s` cannot be the name of a project: use a name that begins with a letter and contains \
          only letters, digits, `_` and `-`%s"
         (Basis.Printable.name name) (suggestion name))
  else if Sys.file_exists (resources.library / (name ^ ".frob")) then
    Error (Printf.sprintf "%s is the name of a library module: use another name" name)
  else C_file.check (name ^ ".frob")

let check_free path =
  match Unix.lstat path with
  | exception Unix.Unix_error ((ENOENT | ENOTDIR), _, _) -> Ok ()
  | exception Unix.Unix_error (reason, _, _) ->
      Error
        (Printf.sprintf "cannot create the folder %s: %s" (Basis.Printable.name path)
           (Unix.error_message reason))
  | { st_kind; _ } ->
      let what = if st_kind = S_DIR then "folder" else "file" in
      Error
        (Printf.sprintf "there is already a %s %s: use another name, or move it away" what
           (Basis.Printable.name path))

(* {1 Files} *)

(* The files of the project, each with its path, its template, and its description. *)
let files ~program =
  [
    (program, "program.frob", "the program, with a trial that checks its behaviour");
    (Resolve.Test_file.path program, "tests.frob", "more trials");
    ("world.toml", "world.toml", "the room in which the trials run");
    ("README.md", "README.md", "the files of the project and the commands to use");
    (".editorconfig", "editorconfig", "settings for editors");
    (".vscode" / "settings.json", "vscode-settings.json", "settings for Visual Studio Code");
    (".gitignore", "gitignore", "ignores the files that trials write");
  ]

let filled ~name ~program text =
  let word = function "@NAME@" -> name | "@FILE@" -> program | other -> other in
  let rec go from =
    match String.index_from_opt text from '@' with
    | None -> [ String.sub text from (String.length text - from) ]
    | Some at ->
        let before = String.sub text from (at - from) in
        let marker = String.sub text at (min 6 (String.length text - at)) in
        let replacement = word marker in
        if String.equal replacement marker then (before ^ "@") :: go (at + 1)
        else before :: replacement :: go (at + 6)
  in
  String.concat "" (go 0)

let read path =
  match Resolve.Files.on_disk.read path with
  | Ok text -> Ok text
  | Error (Missing | Unreadable _) -> Error ("cannot read " ^ path)

let rec each f = function
  | [] -> Ok []
  | x :: others ->
      let* y = f x in
      let* ys = each f others in
      Ok (y :: ys)

(* If writing a file fails, deletes the folder that it created. *)
let make path texts =
  let* () = Output.folder path in
  let* () = Output.folder (path / ".vscode") in
  match Output.write (List.map (fun (file, text) -> (path / file, text)) texts) with
  | Ok () -> Ok ()
  | Error _ as error ->
      let remove folder = try Unix.rmdir folder with Unix.Unix_error _ -> () in
      remove (path / ".vscode");
      remove path;
      error

(* {1 The command} *)

let tell path ~program =
  Printf.printf "created %s:\n" (Basis.Printable.name path);
  List.iter (fun (file, _, what) -> Printf.printf "  %-24s%s\n" file what) (files ~program);
  Printf.printf "\nnext steps:\n  cd %s\n  frobc run %s --view\n  frobc test\n"
    (Basis.Printable.path path) program

let without_slash path =
  let rec last n = if n > 1 && path.[n - 1] = '/' then last (n - 1) else n in
  String.sub path 0 (last (String.length path))

let run path =
  let path = without_slash path in
  let name = if path = "" then path else Filename.basename path in
  let program = name ^ ".frob" in
  let made =
    let* resources = Installation.find () in
    let* () = check_name resources name in
    let* () = check_free path in
    let* texts =
      each
        (fun (file, from, _) ->
          let* text = read (resources.template / from) in
          Ok (file, filled ~name ~program text))
        (files ~program)
    in
    make path texts
  in
  Reporting.(
    let* () = made in
    tell path ~program;
    Exit_status.ok)
