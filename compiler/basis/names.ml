(* Maps each name already returned to the suffix to try when it is requested again. *)
type t = int String_table.t

let create () = String_table.create 64
let mem = String_table.mem

let unique t name =
  let rec numbered k =
    let candidate = Printf.sprintf "%s_%d" name k in
    if String_table.mem t candidate then numbered (k + 1)
    else (
      String_table.replace t name (k + 1);
      String_table.replace t candidate 2;
      candidate)
  in
  match String_table.find_opt t name with
  | Some next -> numbered next
  | None ->
      String_table.replace t name 2;
      name
