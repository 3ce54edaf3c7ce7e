(* For each name given out, the number to try next when it is wanted again. *)
type t = (string, int) Hashtbl.t

let create () = Hashtbl.create 8

let unique t name =
  let rec numbered k =
    let candidate = Printf.sprintf "%s_%d" name k in
    if Hashtbl.mem t candidate then numbered (k + 1)
    else (
      Hashtbl.replace t name (k + 1);
      Hashtbl.replace t candidate 2;
      candidate)
  in
  match Hashtbl.find_opt t name with
  | Some next -> numbered next
  | None ->
      Hashtbl.replace t name 2;
      name
