let ( / ) = Filename.concat

(* {1 The cache folder} *)

let rec make_folder path =
  if not (Sys.file_exists path) then (
    make_folder (Filename.dirname path);
    try Unix.mkdir path 0o700 with Unix.Unix_error (EEXIST, _, _) -> ())

let is_trusted path =
  match
    make_folder path;
    Unix.access path [ W_OK; X_OK ];
    Unix.lstat path
  with
  | { st_kind = S_DIR; st_uid; st_perm; _ } -> st_uid = Unix.geteuid () && st_perm land 0o022 = 0
  | _ | (exception (Unix.Unix_error _ | Sys_error _)) -> false

(* The XDG base directory specification requires relative paths to be ignored. *)
let wanted () =
  let absolute variable =
    Option.bind (Sys.getenv_opt variable) (fun path ->
        if Filename.is_relative path then None else Some path)
  in
  match (absolute "XDG_CACHE_HOME", absolute "HOME") with
  | Some cache, _ -> Some (cache / "frobc")
  | None, Some home -> Some (home / ".cache" / "frobc")
  | None, None -> None

let folder () =
  match wanted () with Some path when is_trusted path -> path | _ -> Temporary.folder ()

let is_kept () =
  match wanted () with
  | Some path when is_trusted path -> Ok path
  | Some path -> Error path
  | None -> Error "the home folder, because HOME is not set"

(* {1 Entries} *)

(* The path of an entry's seal: a file that contains the checksum of the complete entry. *)
let seal path = path ^ ".md5"

let is_whole path =
  match
    let channel = open_in_bin (seal path) in
    let seal =
      Fun.protect
        ~finally:(fun () -> close_in_noerr channel)
        (fun () -> really_input_string channel (in_channel_length channel))
    in
    (* Another command may have written a seal whose entry does not exist yet. *)
    String.equal seal (Digest.file path)
  with
  | is_whole -> is_whole
  | exception (Sys_error _ | End_of_file) -> false

let write path text =
  let channel = open_out_bin path in
  Fun.protect
    ~finally:(fun () -> close_out_noerr channel)
    (fun () ->
      output_string channel text;
      close_out channel)

let work_folder = Printf.sprintf "work-%s.%d"

(* Removes the work folders of processes that were killed. *)
let sweep folder =
  let is_over pid =
    match Unix.kill pid 0 with
    | () -> false
    | exception Unix.Unix_error (reason, _, _) -> reason = ESRCH
  in
  let one name =
    match String.split_on_char '.' name with
    | [ work; pid ] when String.starts_with ~prefix:"work-" work -> (
        match int_of_string_opt pid with
        | Some pid when is_over pid -> Temporary.remove (folder / name)
        | Some _ | None -> ())
    | _ -> ()
  in
  Array.iter one (Sys.readdir folder)

(* Renaming is atomic, so concurrent commands never see an incomplete file. The seal is written
   before the entry; an entry with an outdated seal is rebuilt. *)
let make_entry cache ~key path make =
  sweep cache;
  let work = cache / work_folder key (Unix.getpid ()) in
  Unix.mkdir work 0o700;
  Interruption.protect
    ~finally:(fun () -> Temporary.remove work)
    (fun () ->
      let made = work / "entry" in
      Result.map
        (fun () ->
          write (seal made) (Digest.file made);
          Sys.rename (seal made) (seal path);
          Sys.rename made path)
        (make ~folder:work made))

let fix = "free some space there, or set TMPDIR and XDG_CACHE_HOME to writable folders"

let cannot_write where reason =
  Error (Printf.sprintf "cannot store build results in %s: %s; %s" where reason fix)

let entry ~name ~key ~suffix ~reuse make =
  (* File names are limited to 255 bytes. *)
  let name = String.sub name 0 (min 60 (String.length name)) in
  match folder () with
  | exception Unix.Unix_error (reason, _, where) -> cannot_write where (Unix.error_message reason)
  | cache -> (
      let path = cache / Printf.sprintf "%s-%s%s" name key suffix in
      if reuse && is_whole path then Ok path
      else
        match make_entry cache ~key path make with
        | Ok () -> Ok path
        | Error _ as error -> error
        | exception Unix.Unix_error (reason, _, _) -> cannot_write cache (Unix.error_message reason)
        | exception Sys_error reason -> cannot_write cache reason)
