(* An octal escape has at most three digits, so the next character cannot extend it. *)
let literal text =
  let character c =
    match c with
    | '"' | '\\' | '?' -> Printf.sprintf "\\%c" c
    | ' ' .. '~' -> String.make 1 c
    | c -> Printf.sprintf "\\%03o" (Char.code c)
  in
  "\"" ^ String.concat "" (List.map character (List.of_seq (String.to_seq text))) ^ "\""

(* Inserts a space between two characters that must not be adjacent in a comment. *)
let comment text =
  let apart = [ ('*', '/'); ('/', '*'); ('?', '?') ] in
  let inside = Buffer.create (String.length text) in
  String.iteri
    (fun k c ->
      if k > 0 && List.mem (text.[k - 1], c) apart then Buffer.add_char inside ' ';
      Buffer.add_char inside c)
    text;
  Printable.name (Buffer.contents inside)
