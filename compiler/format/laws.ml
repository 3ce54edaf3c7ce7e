type t = Tree | Comments | Rest

(* Removes trailing spaces from the lines of a doc comment. The rest of the text must stay the same,
   because it is the documentation of a definition. *)
let documentation text =
  String.split_on_char '\n' text |> List.map Reading.without_trailing_blanks |> String.concat "\n"

let same_token (a, made) (b, made') =
  made = made'
  &&
  match ((a : Syntax.Grammar.token), (b : Syntax.Grammar.token)) with
  | DOC a, DOC b -> String.equal (documentation a) (documentation b)
  | a, b -> a = b

let same equal a b =
  Array.length a = Array.length b
  &&
  let rec go i = i = Array.length a || (equal a.(i) b.(i) && go (i + 1)) in
  go 0

let comments (read : Reading.t) =
  let texts = List.map (fun (c : Word.comment) -> c.text) in
  let of_words =
    Array.fold_left
      (fun found (w : Word.t) -> List.rev_append (texts w.comments) found)
      [] read.words
  in
  List.rev_append (texts read.last) of_words

let broken (a : Reading.t) (b : Reading.t) =
  if not (same same_token a.layout b.layout) then Some Tree
  else if not (List.equal String.equal (comments a) (comments b)) then Some Comments
  else None

let name = function
  | Tree -> "the program would be different"
  | Comments -> "a comment would be lost"
  | Rest -> "formatting the result again would change it"
