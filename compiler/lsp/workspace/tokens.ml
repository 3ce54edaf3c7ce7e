type token = { token : Syntax.Grammar.token; start : int; stop : int; first : bool }

let of_text text =
  let lexer = Syntax.Lexer.create ignore ~file:"" text in
  let rec go found =
    let t = Syntax.Lexer.next lexer in
    match t.token with
    | END -> Array.of_list (List.rev found)
    | token ->
        let start = t.start.pos_cnum and stop = t.stop.pos_cnum in
        go ({ token; start; stop; first = t.first } :: found)
  in
  go []

let item text offset =
  let n = String.length text in
  let begins i =
    i = 0
    || text.[i - 1] = '\n'
       && i < n
       && match text.[i] with ' ' | '\t' | '\n' | '\r' -> false | _ -> true
  in
  let rec back i = if i <= 0 || begins i then max 0 i else back (i - 1) in
  let rec forth i = if i >= n || begins i then min n i else forth (i + 1) in
  (back (min offset n), forth (min (offset + 1) n))
