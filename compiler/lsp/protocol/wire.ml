type t = {
  stream : Unix.file_descr;
  buffered : Buffer.t;  (** received data; everything before [from] has been processed *)
  mutable from : int;
  chunk : Bytes.t;
  mutable ended : bool;
}

type event = Message of string | Nothing | End

let create stream =
  { stream; buffered = Buffer.create 65536; from = 0; chunk = Bytes.create 65536; ended = false }

(* Maximum length of a message. A header with a larger length is assumed to be corrupt. *)
let longest = 256 * 1024 * 1024

(* Discards processed data if there is more than 1 MB of it, or if no other data is left. *)
let compact t =
  if t.from > 1_000_000 || t.from = Buffer.length t.buffered then (
    let rest = Buffer.sub t.buffered t.from (Buffer.length t.buffered - t.from) in
    Buffer.reset t.buffered;
    Buffer.add_string t.buffered rest;
    t.from <- 0)

let end_of_header t =
  let n = Buffer.length t.buffered in
  let rec find i =
    if i + 4 > n then None
    else if String.equal (Buffer.sub t.buffered i 4) "\r\n\r\n" then Some i
    else find (i + 1)
  in
  find t.from

(* Uses the last [Content-Length] of the header, so that other text before it does no harm. *)
let length_in header =
  let name = "content-length:" in
  let n = String.length name in
  let of_line line =
    let line = String.trim line in
    if String.length line > n && String.lowercase_ascii (String.sub line 0 n) = name then
      int_of_string_opt (String.trim (String.sub line n (String.length line - n)))
    else None
  in
  List.find_map of_line (List.rev (String.split_on_char '\n' header))

let rec buffered t =
  match end_of_header t with
  | None -> None
  | Some stop -> (
      let header = Buffer.sub t.buffered t.from (stop - t.from) in
      let body = stop + 4 in
      match length_in header with
      | Some length when length >= 0 && length <= longest ->
          if body + length > Buffer.length t.buffered then None
          else
            let text = Buffer.sub t.buffered body length in
            t.from <- body + length;
            compact t;
            Some text
      | Some _ | None ->
          t.from <- body;
          buffered t)

let rec read t =
  match Unix.read t.stream t.chunk 0 (Bytes.length t.chunk) with
  | 0 -> t.ended <- true
  | n -> Buffer.add_subbytes t.buffered t.chunk 0 n
  | exception Unix.Unix_error (EINTR, _, _) -> read t
  | exception Unix.Unix_error _ -> t.ended <- true

let rec is_ready t timeout =
  match Unix.select [ t.stream ] [] [] timeout with
  | ready, _, _ -> ready <> []
  | exception Unix.Unix_error (EINTR, _, _) -> is_ready t timeout

let rec next t ~timeout =
  match buffered t with
  | Some text -> Message text
  | None when t.ended -> End
  | None ->
      if is_ready t timeout then (
        read t;
        next t ~timeout)
      else Nothing

let rec wait t others =
  match Unix.select (t.stream :: others) [] [] (-1.) with
  | ready, _, _ -> List.filter (fun other -> List.mem other ready) others
  | exception Unix.Unix_error (EINTR, _, _) -> wait t others

let write channel json =
  let text = Basis.Json.to_string json in
  Printf.fprintf channel "Content-Length: %d\r\n\r\n%s" (String.length text) text;
  flush channel
