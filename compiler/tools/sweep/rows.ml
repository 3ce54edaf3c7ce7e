type t = (string, string list) Hashtbl.t

let create () = Hashtbl.create 1024
let suffix = ".rows"

(* 64-bit FNV-1a. *)
let checksum text =
  let step hash c = Int64.mul (Int64.logxor hash (Int64.of_int (Char.code c))) 1099511628211L in
  String.fold_left step (-3750763034362895579L) text

let add t line =
  match String.rindex_opt line '\t' with
  | None -> ()
  | Some at -> (
      let said = String.sub line (at + 1) (String.length line - at - 1) in
      let text = String.sub line 0 at in
      if String.equal said (Printf.sprintf "%016Lx" (checksum text)) then
        match String.split_on_char '\t' text with
        | key :: cells -> Hashtbl.replace t key cells
        | [] -> ())

let load_file t path =
  let channel = open_in_bin path in
  Fun.protect
    ~finally:(fun () -> close_in channel)
    (fun () ->
      let text = Lines.of_channel channel in
      (* A line that is too long is not a row. Loading stops there, because no row can follow it. *)
      let rec lines () =
        match Lines.next text with
        | Some line ->
            add t line;
            lines ()
        | None | (exception Lines.Too_long) -> ()
      in
      lines ())

let load t folder =
  if Sys.file_exists folder then
    let load name =
      if Filename.check_suffix name suffix then load_file t (Filename.concat folder name)
    in
    Array.iter load (Sys.readdir folder)

let find = Hashtbl.find_opt

let fresh folder =
  let now = Int64.of_float (Unix.gettimeofday () *. 1e6) in
  let host = String.map (function '/' | '\000' -> '-' | c -> c) (Unix.gethostname ()) in
  let rec create number =
    let name = Printf.sprintf "%s-%Lx-%d-%d%s" host now (Unix.getpid ()) number suffix in
    let path = Filename.concat folder name in
    match Unix.openfile path [ O_WRONLY; O_CREAT; O_EXCL; O_CLOEXEC ] 0o644 with
    | descriptor -> (path, descriptor)
    | exception Unix.Unix_error (EEXIST, _, _) -> create (number + 1)
  in
  create 1
