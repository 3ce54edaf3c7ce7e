type result = Formatted of string | Broken | Refused of Laws.t

let once ~break (read : Reading.t) =
  Spacing.set read.words;
  Alignment.set read.words;
  Writing.text read (Indentation.lines ~break read.words)

(* Aligning one group may make room for another, so formatting is repeated until nothing changes. *)
let most_rounds = 4

let rec rounds ~break n original text =
  let again = Reading.text text in
  match Laws.broken original again with
  | Some law -> Error law
  | None ->
      let next = once ~break again in
      if String.equal next text then Ok text
      else if n = most_rounds then Error Laws.Rest
      else rounds ~break (n + 1) original next

let formatted ~break text =
  let read = Reading.text text in
  rounds ~break 1 read (once ~break read)

let without_tabs text =
  if String.contains text '\t' && Basis.Utf8.first_error text = None then
    Option.value (Tabs.expanded text) ~default:text
  else text

let text facts ~file text =
  let as_before after = Formatted (Basis.Line_ends.write (Basis.Line_ends.of_text text) after) in
  let text = without_tabs text in
  match Syntax.Parse.program facts ~file text with
  | None -> Broken
  | Some _ -> (
      match formatted ~break:true text with
      | Ok text -> as_before text
      | Error _ -> (
          match formatted ~break:false text with
          | Ok text -> as_before text
          | Error law -> Refused law))
