let singular word =
  let n = String.length word in
  if n > 3 && word.[n - 1] = 's' then String.sub word 0 (n - 1) else word

let symbol word =
  Option.bind
    (Phrasebook.find Unit (singular (String.lowercase_ascii word)))
    (fun row -> row.replacement)
