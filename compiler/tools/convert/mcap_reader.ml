type record =
  | Attachment of { name : string; copy : out_channel -> unit }
  | Message of { topic : string; data : string }

open Basis.Let_syntax.Result

exception Wrong of string

let wrong text = raise_notrace (Wrong text)
let damaged () = wrong "it is damaged: a checksum does not match its content"

(* {1 Fields}

   Each function returns the field at the given offset in the text. [string] also returns the offset
   of the next field. *)

let long text at = Int64.to_int (String.get_int64_le text at)
let u16 text at = String.get_uint16_le text at
let u32 text at = Int32.to_int (String.get_int32_le text at) land 0xffffffff

let string text at =
  let length = u32 text at in
  (String.sub text (at + 4) length, at + 4 + length)

let head_size = 9

(* {1 Chunks} *)

let add_channel topics record =
  let id = u16 record 0 in
  let topic, _ = string record 4 in
  Hashtbl.replace topics id topic

let message topics record =
  match Hashtbl.find_opt topics (u16 record 0) with
  | Some topic -> Message { topic; data = String.sub record 22 (String.length record - 22) }
  | None -> wrong "it is damaged: a message has no channel"

let in_chunk topics run chunk =
  let crc = u32 chunk 24 in
  let compression, at = string chunk 28 in
  if compression <> "" then wrong (Printf.sprintf "its chunks are compressed (%s)" compression);
  let records = String.sub chunk (at + 8) (long chunk at) in
  if Crc32.update 0 records <> crc then damaged ();
  let rec from at =
    if at = String.length records then Ok ()
    else
      let record = String.sub records (at + head_size) (long records (at + 1)) in
      let next = at + head_size + String.length record in
      match records.[at] with
      | '\x04' ->
          add_channel topics record;
          from next
      | '\x05' ->
          let* () = run (message topics record) in
          from next
      | _ -> from next
  in
  from 0

(* {1 Attachments} *)

let attachment channel ~length =
  let fixed = really_input_string channel 16 in
  let next () =
    let head = really_input_string channel 4 in
    if u32 head 0 > length then wrong "it is damaged";
    (head, really_input_string channel (u32 head 0))
  in
  let name_head, name = next () in
  let type_head, media_type = next () in
  let size_text = really_input_string channel 8 in
  let fields = String.concat "" [ fixed; name_head; name; type_head; media_type; size_text ] in
  let size = long size_text 0 in
  if size < 0 || String.length fields + size + 4 > length then wrong "it is damaged";
  let copy out =
    let rec from crc left =
      if left = 0 then crc
      else
        let part = really_input_string channel (min left 65536) in
        output_string out part;
        from (Crc32.update crc part) (left - String.length part)
    in
    let crc = from (Crc32.update 0 fields) size in
    if crc <> u32 (really_input_string channel 4) 0 then damaged ()
  in
  Attachment { name; copy }

(* {1 Files} *)

let magic = "\x89MCAP0\r\n"

let rec records channel topics run ~size at =
  seek_in channel at;
  let head = really_input_string channel head_size in
  let length = long head 1 in
  let start = at + head_size in
  if length < 0 || length > size - start then wrong "it is truncated or damaged";
  let whole () = really_input_string channel length in
  let* () =
    match head.[0] with
    | '\x01' ->
        let header = whole () in
        let _, at = string header 0 in
        if fst (string header at) <> "frobc" then
          wrong "it was not written by `frobc convert`, so it contains no recording";
        Ok ()
    | '\x06' -> in_chunk topics run (whole ())
    | '\x09' -> run (attachment channel ~length)
    | _ -> Ok ()
  in
  (* The records after the data section repeat its contents. *)
  if head.[0] = '\x0f' then Ok () else records channel topics run ~size (start + length)

let is_ours path =
  let channel = open_in_bin path in
  let finally () = close_in_noerr channel in
  Fun.protect ~finally (fun () ->
      match
        let start = really_input_string channel (String.length magic + head_size) in
        let header =
          really_input_string channel (min 4096 (long start (String.length magic + 1)))
        in
        let _, at = string header 0 in
        fst (string header at)
      with
      | library -> library = "frobc"
      (* [iter] will report what is wrong with the file. *)
      | exception (End_of_file | Invalid_argument _) -> true)

let iter path run =
  let channel = open_in_bin path in
  let finally () = close_in_noerr channel in
  let cannot reason =
    Error (Printf.sprintf "cannot read %s: %s" (Basis.Printable.name path) reason)
  in
  Fun.protect ~finally (fun () ->
      let size = in_channel_length channel and n = String.length magic in
      if size < n || really_input_string channel n <> magic then cannot "it is not an MCAP file"
      else
        match records channel (Hashtbl.create 16) run ~size n with
        | result -> result
        | exception Wrong reason -> cannot reason
        | exception End_of_file -> cannot "it is truncated"
        | exception Invalid_argument _ -> cannot "it is damaged")
