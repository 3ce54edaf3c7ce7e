module Strings = Map.Make (String)

(* For each name given out, the number to try next when it is wanted again. *)
type t = { mutable next : int Strings.t }

let create () = { next = Strings.empty }

let unique t name =
  let rec numbered k =
    let candidate = Printf.sprintf "%s_%d" name k in
    if Strings.mem candidate t.next then numbered (k + 1)
    else (
      t.next <- Strings.add candidate 2 (Strings.add name (k + 1) t.next);
      candidate)
  in
  match Strings.find_opt name t.next with
  | Some next -> numbered next
  | None ->
      t.next <- Strings.add name 2 t.next;
      name
