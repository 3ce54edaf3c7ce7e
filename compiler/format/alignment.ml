open Syntax.Grammar

(* The role of a line within its block or list. *)
type role = Item | Element | Guard

type line = {
  frame : int;
  role : role;
  sign : Syntax.Grammar.token;
  at : int;  (** the index of the word that is aligned, such as [=] *)
  wanted : int;
      (** the column that the sign would have without extra spaces, counted from the line's first
          word *)
  written : int;  (** column of the sign in the source *)
  padded : bool;  (** whether several spaces precede the sign *)
  line : int;
}

(* The maximum number of columns by which a line may move an aligned group when it joins the
   group. *)
let most_joining = 8

let is_sign ~(role : role) ~of_cases = function
  | ARROW -> of_cases && role <> Element
  | EQUAL | DOUBLE_COLON | LEFT_ARROW -> true
  | _ -> false

(* Finds the sign of the line that starts with this word, if there is one. *)
let line_from (words : Word.t array) first =
  let n = Array.length words in
  let w = words.(first) in
  let role, inner =
    match w.token.token with
    | BAR -> (Guard, first + 1)
    | COMMA -> (Element, first + 1)
    | (LPAREN | LBRACKET | LBRACE) when w.commas_first -> (Element, first + 1)
    | _ -> (Item, first)
  in
  if inner >= n || (words.(inner).starts && inner > first) then None
  else
    let frame = words.(inner).frame and of_cases = words.(inner).of_cases in
    let rec go i wanted =
      if i >= n || (i > first && (words.(i).starts || words.(i).comments <> [])) then None
      else
        let v = words.(i) in
        let wanted = wanted + if i = first then 0 else v.gap in
        if v.frame = frame && i > inner && is_sign ~role ~of_cases v.token.token then
          let before = words.(i - 1) in
          let padded = v.column > before.column + before.width + 1 in
          Some
            {
              frame;
              role;
              sign = v.token.token;
              at = i;
              wanted;
              written = v.column;
              padded;
              line = v.line;
            }
        else go (i + 1) (wanted + v.width)
    in
    match (role, w.item) with Item, false -> None | _ -> go first 0

(* Whether the sign of a line shares its column with other signs, and at least one of them was moved
   there by extra spaces. *)
let shared group =
  let columns = Hashtbl.create 16 in
  let count line =
    let lines, padded = Option.value (Hashtbl.find_opt columns line.written) ~default:(0, false) in
    Hashtbl.replace columns line.written (lines + 1, padded || line.padded)
  in
  List.iter count group;
  fun line ->
    match Hashtbl.find_opt columns line.written with
    | Some (lines, padded) -> lines > 1 && padded
    | None -> false

let align (words : Word.t array) group =
  let aligned, others = List.partition (shared group) group in
  let most = List.fold_left (fun most line -> max most line.wanted) 0 aligned in
  (* The shortest line comes first, since each line that joins may make room for the next. *)
  let others = List.sort (fun a b -> Int.compare a.wanted b.wanted) others in
  let join (most, aligned) line =
    if line.wanted <= most + most_joining then (max most line.wanted, line :: aligned)
    else (most, aligned)
  in
  if aligned <> [] then
    let most, aligned = List.fold_left join (most, aligned) others in
    List.iter
      (fun line ->
        let sign = words.(line.at) in
        sign.gap <- sign.gap + most - line.wanted)
      aligned

let set (words : Word.t array) =
  (* the current group of each frame, with its last line first *)
  let groups = Hashtbl.create 64 in
  let blank = ref 0 in
  let finish frame =
    Option.iter (fun group -> align words (List.rev group)) (Hashtbl.find_opt groups frame);
    Hashtbl.remove groups frame
  in
  let add line =
    match Hashtbl.find_opt groups line.frame with
    | Some (last :: _ as group)
      when last.role = line.role && last.sign = line.sign && !blank <= last.line ->
        Hashtbl.replace groups line.frame (line :: group)
    | Some _ | None ->
        finish line.frame;
        Hashtbl.replace groups line.frame [ line ]
  in
  Array.iteri
    (fun i (w : Word.t) ->
      let is_blank (c : Word.comment) = c.blank_before in
      if w.blank_before || List.exists is_blank w.comments then blank := w.line;
      if w.starts then
        match line_from words i with Some line -> add line | None -> if w.item then finish w.frame)
    words;
  List.iter finish (List.of_seq (Hashtbl.to_seq_keys groups))
