let scheme = "file://"
let is_file uri = String.starts_with ~prefix:scheme uri

let decode text =
  let buffer = Buffer.create (String.length text) in
  let n = String.length text in
  let rec go i =
    if i < n then
      let code =
        if text.[i] = '%' && i + 2 < n then int_of_string_opt ("0x" ^ String.sub text (i + 1) 2)
        else None
      in
      match code with
      | Some code ->
          Buffer.add_char buffer (Char.chr (code land 255));
          go (i + 3)
      | None ->
          Buffer.add_char buffer text.[i];
          go (i + 1)
  in
  go 0;
  Buffer.contents buffer

(* The scheme may be followed by the name of this computer. *)
let to_path uri =
  if not (is_file uri) then uri
  else
    let n = String.length scheme in
    let rest = String.sub uri n (String.length uri - n) in
    decode
      (match String.index_opt rest '/' with
      | Some slash -> String.sub rest slash (String.length rest - slash)
      | None -> "/" ^ rest)

let of_path path =
  if String.contains path ':' && not (String.starts_with ~prefix:"/" path) then path
  else
    let buffer = Buffer.create (String.length path + 16) in
    Buffer.add_string buffer scheme;
    String.iter
      (function
        | ('a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '/' | '-' | '_' | '.' | '~') as c ->
            Buffer.add_char buffer c
        | c -> Buffer.add_string buffer (Printf.sprintf "%%%02X" (Char.code c)))
      path;
    Buffer.contents buffer
