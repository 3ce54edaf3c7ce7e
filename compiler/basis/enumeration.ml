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
