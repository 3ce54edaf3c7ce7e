let ( / ) = Filename.concat

let rec remove path =
  try
    match (Unix.lstat path).st_kind with
    | S_DIR ->
        Array.iter (fun name -> remove (path / name)) (Sys.readdir path);
        Unix.rmdir path
    | _ -> Unix.unlink path
  with Unix.Unix_error _ | Sys_error _ -> ()

(* Starts a process that waits until no process has the write end of its pipe open, and then removes
   the folder. It runs in its own session, so that Ctrl-C does not reach it, and it keeps none of
   our streams open. *)
let remove_at_the_end path =
  let read, write = Unix.pipe () in
  match Unix.fork () with
  | 0 ->
      ignore (Unix.setsid ());
      Unix.close write;
      let null = Unix.openfile "/dev/null" [ Unix.O_RDWR ] 0 in
      List.iter (Unix.dup2 null) [ Unix.stdin; Unix.stdout; Unix.stderr ];
      ignore (Unix.read read (Bytes.create 1) 0 1);
      remove path;
      Unix._exit 0
  | _ -> Unix.close read

let folder () =
  let random = Random.State.make_self_init () in
  let rec fresh attempts =
    let name = Printf.sprintf "frobc-%08x" (Random.State.bits random) in
    let path = Filename.get_temp_dir_name () / name in
    match Unix.mkdir path 0o700 with
    | () -> path
    | exception Unix.Unix_error (EEXIST, _, _) when attempts > 0 -> fresh (attempts - 1)
  in
  let path = fresh 100 in
  remove_at_the_end path;
  path
