open Basis
open Syntax
open Grammar
open Found

let items : Layout.block -> string = function
  | Top | Let | Where -> "definitions"
  | Do | Rec -> "statements"
  | Of -> "branches"

(* The column of the first token on the found token's line. *)
let line_column found =
  let bol = found.token.start.pos_bol in
  let rec go i = if is_blank (char_at found i) && char_at found i <> '\n' then go (i + 1) else i in
  go bol - bol + 1

(* The last non-empty line above with `where` appended, if that line may begin a definition that
   continues here. *)
let where_above found =
  let bol = found.token.start.pos_bol in
  let rec above bol =
    if bol = 0 then ""
    else
      let start =
        Option.value (String.rindex_from_opt found.text (max 0 (bol - 2)) '\n') ~default:(-1) + 1
      in
      match between found start (bol - 1) with "" -> above start | line -> line
  in
  let line = above bol in
  let words = String.split_on_char ' ' line in
  let is_definition = List.mem "=" words || List.mem "->" words in
  let is_open = List.mem (List.hd (List.rev words)) [ "where"; "do"; "of"; "="; "->" ] in
  let count c = List.length (String.split_on_char c line) in
  let is_closed = count '(' = count ')' && count '[' = count ']' in
  let last = List.hd (List.rev words) in
  if is_definition && last <> "where" && Suggest.closest last [ "where" ] <> None then
    let n = String.length line - String.length last in
    Some (String.sub line 0 n ^ "where")
  else if is_definition && is_closed && (not is_open) && String.length line <= 50 then
    Some (line ^ " where")
  else None

let misplaced_line found =
  match innermost found.context with
  | Some (Let, { column; _ })
    when found.token.first && found.token.column > 1 && found.token.column < column ->
      let line =
        between found found.token.start.pos_cnum (end_of_line found found.token.start.pos_cnum)
      in
      let example =
        if String.length line > 60 then "as in `let x = 1 in x + x`"
        else Printf.sprintf "`in %s`" line
      in
      Some
        (Printf.sprintf
           "put `in` before the expression, %s; if this is another definition, start it at column \
            %d"
           example column)
  | Some (((Where | Do | Of | Rec) as block), { column; _ })
    when found.token.first && found.token.column > 1 && found.token.column < column ->
      Some
        (Printf.sprintf "the %s of this block start at column %d, but this line starts at column %d"
           (items block) column found.token.column)
  | Some (block, { column; _ }) when (not found.token.first) && line_column found > column -> (
      match (found.token.token, block) with
      | (EQUAL | DOUBLE_COLON), (Top | Let | Where) | ARROW, Of | (LEFT_ARROW | TAIL), (Do | Rec) ->
          let line_start = found.token.start.pos_bol in
          (* the block or the item starts on this line *)
          let own_line =
            match found.context with
            | (_, { by; _ }) :: _ -> by.start.pos_bol = line_start
            | [] -> false
          in
          if own_line then None
          else
            let continues =
              Printf.sprintf
                "this line is indented further than column %d, where the %s of this block start, \
                 so it continues the line above"
                column (items block)
            in
            Some
              (match where_above found with
              | Some line
                when found.token.token = EQUAL
                     && (block = Top || List.mem "proc" (String.split_on_char ' ' line)) ->
                  Printf.sprintf "%s; if it is an equation, add `where` to that line: `%s`"
                    continues line
              | _ ->
                  Printf.sprintf "%s; if you meant a separate line, start it at column %d" continues
                    column)
      | _ -> None)
  | Some _ | None -> None

(* A hint about a block in braces. Its topic keeps the lines of the block from being reported
   separately. *)
let of_block format = Diagnostic.suggestion ~topic:Syntax_topic.Block_in_braces format
let written value = Option.value (Other_notation.expression value) ~default:value

(* The equation in `v = 1;`, `float v = 1;` or `let v = 1`. *)
let equation line =
  match String.index_opt line '=' with
  | Some i when i + 1 < String.length line && line.[i + 1] <> '=' -> (
      let value = String.trim (String.sub line (i + 1) (String.length line - i - 1)) in
      match List.rev (String.split_on_char ' ' (String.trim (String.sub line 0 i))) with
      | name :: ([] | [ _ ]) when name <> "" && String.for_all Character.is_name name ->
          Some (Printf.sprintf "%s = %s" name (written value))
      | _ -> None)
  | Some _ | None -> None

(* `proc i -> { v = 1; return f v }`: the output, followed by a `where` with the equations.
   [closing]: the brackets that close after the braces. *)
let with_where ~head ~closing lines =
  let ends suffix = String.ends_with ~suffix head in
  match List.rev lines with
  | last :: (_ :: _ as equations) when ends "->" || ends "=" -> (
      let prefix = "return " in
      let n = String.length prefix in
      let output =
        if String.starts_with ~prefix last then
          Some (String.trim (String.sub last n (String.length last - n)))
        else if equation last = None then Some last
        else None
      in
      let equations = List.rev_map equation equations in
      match output with
      | Some output when not (List.mem None equations) ->
          let last = List.length equations - 1 in
          let shown i e = Printf.sprintf "`%s%s`" e (if i = last then closing else "") in
          Some
            (of_block
               "write the output first, and the equations below it in a `where`: `%s %s where`, \
                and below it, indented, %s"
               head (written output)
               (String.concat ", " (List.mapi shown (List.filter_map Fun.id equations))))
      | Some _ | None -> None)
  | _ -> None

let without_braces found =
  let by_indentation = of_block "indent the block instead: braces are only for records" in
  let on_lines format =
    of_block ("write it without braces, each part on a line of its own: " ^^ format)
  in
  match Other_definition.in_braces found.text found.token.start.pos_cnum with
  | Some (inside, after)
    when (not (String.contains inside '{')) && String.length inside < 200 && inside <> "" -> (
      let parts = String.split_on_char ';' inside in
      let lines = List.concat_map (String.split_on_char '\n') parts in
      let lines = List.filter (( <> ) "") (List.map String.trim lines) in
      let head = between found found.token.start.pos_bol found.token.start.pos_cnum in
      let closing = between found after (end_of_line found after) in
      let closing = if String.for_all (( = ) ')') closing then closing else "" in
      match lines with
      | _ when with_where ~head ~closing lines <> None ->
          Option.get (with_where ~head ~closing lines)
      | _ when String.length inside >= 80 -> by_indentation
      | [ first; second ] -> on_lines "`%s`, and below it `%s`" first second
      | first :: second :: _ -> on_lines "`%s`, below it `%s`, and so on" first second
      | [ line ] -> Diagnostic.suggestion "remove the braces, which are only for records: `%s`" line
      | [] -> by_indentation)
  | Some _ | None -> by_indentation

(* Equations below `proc i ->`, and the output below them. *)
let equations_before_output found =
  let lines = String.split_on_char '\n' found.text in
  let number = found.token.start.pos_lnum in
  let line i = if i < 1 then "" else Option.value (List.nth_opt lines (i - 1)) ~default:"" in
  let indentation text =
    let rec go i = if i < String.length text && text.[i] = ' ' then go (i + 1) else i in
    go 0
  in
  let own = indentation (line number) in
  let rec block i =
    let text = line i in
    if String.trim text <> "" && indentation text = own then String.trim text :: block (i + 1)
    else []
  in
  let head = line (number - 1) in
  match found.token.token with
  | EQUAL when own > indentation head && not (in_brackets found.context) ->
      with_where ~head:(String.trim head) ~closing:"" (block number)
  | _ -> None

let of_where found =
  match (found.token.token, found.before) with
  | WHERE, None ->
      Some "indent `where` and the lines below it, because they belong to the definition above"
  | _ -> None

let not_indented found =
  match (found.token.token, found.before) with
  | (END | SEMICOLON), before
    when Parse.expects_more before && (not found.token.last)
         && (found.token.token = END || found.token.made) ->
      Some "to continue a definition on the next line, indent that line further than the first"
  | _ -> None
