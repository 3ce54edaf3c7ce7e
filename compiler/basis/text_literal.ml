let written text =
  let character c =
    match c with
    | '"' | '\\' -> Printf.sprintf "\\%c" c
    | '\n' -> "\\n"
    | '\t' -> "\\t"
    | c -> String.make 1 c
  in
  "\"" ^ String.concat "" (List.map character (List.of_seq (String.to_seq text))) ^ "\""
