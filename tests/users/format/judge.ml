(* Trailing whitespace does not count; in documentation comments it would be part of the text. *)
let trimmed text =
  let line text =
    let rec stop i =
      if i > 0 && (text.[i - 1] = ' ' || text.[i - 1] = '\r') then stop (i - 1) else i
    in
    String.sub text 0 (stop (String.length text))
  in
  String.concat "\n" (List.map line (String.split_on_char '\n' text))

let parsed text =
  Syntax.Parse.program (Basis.Facts.ignored ()) ~file:"" (trimmed text)
  |> Option.map Without_spans.program

let comments text =
  let n = String.length text in
  let at i = if i < n then text.[i] else '\000' in
  let rec go found i =
    if i >= n then List.rev found
    else
      match (at i, at (i + 1)) with
      | '-', '-' ->
          let stop = Option.value (String.index_from_opt text i '\n') ~default:n in
          go (trimmed (String.sub text i (stop - i)) :: found) stop
      | '{', '-' ->
          let stop = nested 1 (i + 2) in
          go (trimmed (String.sub text i (stop - i)) :: found) stop
      | '"', _ -> go found (quoted (i + 1))
      (* one token, regardless of what follows *)
      | '<', '-' -> go found (i + 2)
      | _ -> go found (i + 1)
  and nested depth i =
    if depth = 0 then i
    else
      match (at i, at (i + 1)) with
      | '{', '-' -> nested (depth + 1) (i + 2)
      | '-', '}' -> nested (depth - 1) (i + 2)
      | _ -> nested depth (i + 1)
  and quoted i = match at i with '"' -> i + 1 | '\\' -> quoted (i + 2) | _ -> quoted (i + 1) in
  go [] 0

let formatted text =
  match Formatting.Formatter.text (Basis.Facts.ignored ()) ~file:"" text with
  | Formatted text -> Ok text
  | Broken -> Error "it is no program to the formatter"
  | Refused law -> Error ("the formatter refuses: " ^ Formatting.Laws.name law)

let verdict text =
  match formatted text with
  | Error _ as error -> error
  | Ok result ->
      if parsed result <> parsed text then Error ("another program:\n" ^ result)
      else if comments result <> comments text then Error ("other comments:\n" ^ result)
      else if formatted result <> Ok result then Error ("not the same again:\n" ^ result)
      else Ok result
