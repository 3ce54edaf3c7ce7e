(* Is this byte an ASCII control character, or the second byte of a control character U+0080 to
   U+009F in UTF-8? *)
let is_control text k =
  let c = text.[k] in
  c < ' ' || c = '\127' || (c >= '\128' && c < '\160' && k > 0 && text.[k - 1] = '\194')

let escaped ~keep text =
  let is_control k = is_control text k && not (String.contains keep text.[k]) in
  let shown = Buffer.create (String.length text) in
  String.iteri
    (fun k c ->
      if is_control k then Buffer.add_string shown (Printf.sprintf "\\%03d" (Char.code c))
      else if c = '\194' && k + 1 < String.length text && is_control (k + 1) then ()
      else Buffer.add_char shown c)
    text;
  Buffer.contents shown

let name text = escaped ~keep:"" text
let text text = escaped ~keep:"\n\t" text

let is_plain = function
  | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' -> true
  | '_' | '-' | '.' | '/' | '+' | ':' | ',' | '%' | '@' | '=' -> true
  | _ -> false

(* Quotes a word that contains control characters: shells interpret [\ooo] within [$'...']. *)
let with_escapes text =
  let quoted = Buffer.create (2 * String.length text) in
  let octal c = Printf.bprintf quoted "\\%03o" (Char.code c) in
  Buffer.add_string quoted "$'";
  String.iteri
    (fun k c ->
      let begins_one = c = '\194' && k + 1 < String.length text && is_control text (k + 1) in
      if begins_one || is_control text k || c = '\'' || c = '\\' then octal c
      else Buffer.add_char quoted c)
    text;
  Buffer.add_char quoted '\'';
  Buffer.contents quoted

let word text =
  if text <> "" && String.for_all is_plain text then text
  else if List.exists (is_control text) (List.init (String.length text) Fun.id) then
    with_escapes text
  else Filename.quote text

let operand path = if String.starts_with ~prefix:"-" path then "./" ^ path else path
let path text = word (operand text)
