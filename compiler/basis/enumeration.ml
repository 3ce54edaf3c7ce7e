let joined word = function
  | [] -> ""
  | [ one ] -> one
  | several ->
      let reversed = List.rev several in
      Printf.sprintf "%s %s %s"
        (String.concat ", " (List.rev (List.tl reversed)))
        word (List.hd reversed)

let all = joined "and"
let one_of = joined "or"

let some listed ~more =
  if more = 0 then all listed else Printf.sprintf "%s and %d more" (String.concat ", " listed) more

let rec once = function
  | a :: b :: others when String.equal a b -> once (b :: others)
  | a :: others -> a :: once others
  | [] -> []

let longest_shown = 12

(* The shortest period of the list: [a; b] for [a; b; a; b]. *)
let period names =
  let names = Array.of_list names in
  let n = Array.length names in
  let is_again k i = names.(i) = names.(i mod k) in
  let repeats k = n mod k = 0 && List.for_all (is_again k) (List.init n Fun.id) in
  let rec least k = if repeats k then k else least (k + 1) in
  Array.to_list (Array.sub names 0 (least 1))

let circle names =
  let names = period names in
  let path = match once (names @ [ List.hd names ]) with [ one ] -> [ one; one ] | path -> path in
  let left_out = List.length path - longest_shown in
  let shown i name =
    if left_out <= 0 || i < longest_shown - 2 || i > longest_shown - 2 + left_out then Some name
    else if i = longest_shown - 2 then Some "…"
    else None
  in
  "`" ^ String.concat " → " (List.filter_map Fun.id (List.mapi shown path)) ^ "`"
