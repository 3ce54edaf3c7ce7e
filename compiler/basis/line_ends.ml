type t = Lf | Crlf

let of_text text =
  match String.index_opt text '\n' with
  | Some k when k > 0 && text.[k - 1] = '\r' -> Crlf
  | Some _ | None -> Lf

let write ends text =
  let n = String.length text in
  let out = Buffer.create (n + 64) in
  String.iteri
    (fun k c ->
      match c with
      | '\r' when k + 1 < n && text.[k + 1] = '\n' -> ()
      | '\n' -> Buffer.add_string out (match ends with Lf -> "\n" | Crlf -> "\r\n")
      | c -> Buffer.add_char out c)
    text;
  Buffer.contents out
