open Basis
open Grammar

type token = {
  token : Grammar.token;
  start : Lexing.position;
  stop : Lexing.position;
  column : int;
  first : bool;
  doc : string option;
}

type t = {
  report : Lexical_fact.t -> unit;
  file : string;
  text : string;
  mutable at : int;
  mutable line : int;
  mutable line_start : int;  (** byte offset *)
  mutable extra : int;
      (** number of continuation bytes of UTF-8 characters on this line before [at] *)
  mutable fresh : bool;  (** whether no token has been read on this line yet *)
  mutable doc : string list;  (** lines of the current doc comment, in reverse order *)
  mutable doc_line : int;  (** line number of the last line in [doc] *)
  mutable bad_line : int;  (** line number of the last unexpected character *)
  mutable cut_off : bool;  (** an unterminated comment hides the rest of the text *)
}

let copy t = { t with at = t.at }
let byte_order_mark = "\xef\xbb\xbf"

let create report ~file text =
  let marked = String.length text >= 3 && String.equal (String.sub text 0 3) byte_order_mark in
  let at = if marked then 3 else 0 in
  {
    report;
    file;
    text;
    at;
    line = 1;
    line_start = 0;
    extra = (if marked then 3 else 0);
    fresh = true;
    doc = [];
    doc_line = 0;
    bad_line = 0;
    cut_off = false;
  }

(* Returns NUL past the end. No token contains a NUL. *)
let peek t offset =
  let i = t.at + offset in
  if i < String.length t.text then String.unsafe_get t.text i else '\000'

let at_end t = t.at >= String.length t.text

let position t : Lexing.position =
  { pos_fname = t.file; pos_lnum = t.line; pos_bol = t.line_start; pos_cnum = t.at }

(* Advances by one byte within a line. *)
let step t =
  if Utf8.is_continuation t.text.[t.at] then t.extra <- t.extra + 1;
  t.at <- t.at + 1

let newline t =
  t.at <- t.at + 1;
  t.line <- t.line + 1;
  t.line_start <- t.at;
  t.extra <- 0;
  t.fresh <- true

let report t ~start problem = t.report { at = Build.span (start, position t); problem }

(* {1 Comments} *)

let skip_line t =
  let stop =
    match String.index_from_opt t.text t.at '\n' with
    | Some newline -> newline
    | None -> String.length t.text
  in
  for i = t.at to stop - 1 do
    if Utf8.is_continuation t.text.[i] then t.extra <- t.extra + 1
  done;
  t.at <- stop

let line_comment t =
  let fresh = t.fresh in
  let start = t.at + 2 in
  skip_line t;
  let stop = if t.text.[t.at - 1] = '\r' then t.at - 1 else t.at in
  let text = String.sub t.text start (max 0 (stop - start)) in
  let without_blank s =
    if s <> "" && s.[0] = ' ' then String.sub s 1 (String.length s - 1) else s
  in
  let text = without_blank text in
  if fresh then
    if text <> "" && text.[0] = '|' then (
      t.doc <- [ without_blank (String.sub text 1 (String.length text - 1)) ];
      t.doc_line <- t.line)
    else if t.doc <> [] && t.doc_line = t.line - 1 then (
      t.doc <- text :: t.doc;
      t.doc_line <- t.line)

let nested_comment t =
  let start = position t in
  t.at <- t.at + 2;
  let opener_stop = position t in
  let rec go depth =
    if depth > 0 then
      if at_end t then (
        t.cut_off <- true;
        t.report { at = Build.span (start, opener_stop); problem = Comment_not_closed })
      else
        match (peek t 0, peek t 1) with
        | '{', '-' ->
            t.at <- t.at + 2;
            go (depth + 1)
        | '-', '}' ->
            t.at <- t.at + 2;
            go (depth - 1)
        | '\n', _ ->
            newline t;
            go depth
        | _ ->
            step t;
            go depth
  in
  go 1

let rec skip_blanks t =
  match (peek t 0, peek t 1) with
  | (' ' | '\t'), _ ->
      t.at <- t.at + 1;
      skip_blanks t
  | '\n', _ ->
      newline t;
      skip_blanks t
  | '\r', '\n' ->
      t.at <- t.at + 1;
      skip_blanks t
  | '-', '-' ->
      line_comment t;
      skip_blanks t
  | '{', '-' ->
      nested_comment t;
      skip_blanks t
  | _ -> ()

(* {1 Names and numbers} *)

let words =
  [
    ("let", LET);
    ("in", IN);
    ("where", WHERE);
    ("do", DO);
    ("of", OF);
    ("case", CASE);
    ("if", IF);
    ("then", THEN);
    ("else", ELSE);
    ("proc", PROC);
    ("rec", REC);
    ("module", MODULE);
    ("import", IMPORT);
    ("qualified", QUALIFIED);
    ("as", AS);
    ("data", DATA);
    ("type", TYPE);
    ("unit", UNIT);
    ("primitive", PRIMITIVE);
    ("_", UNDERSCORE);
    ("class", CLASS);
    ("instance", INSTANCE);
    ("foreign", FOREIGN);
    ("param", PARAM);
    ("deriving", RESERVED "deriving");
    ("newtype", RESERVED "newtype");
  ]

let keywords =
  List.filter_map (function _, (RESERVED _ | UNDERSCORE) -> None | word, _ -> Some word) words

let reserved =
  let table = String_table.create 64 in
  List.iter (fun (word, token) -> String_table.replace table word token) words;
  String_table.find_opt table

(* Longer names are truncated, because messages, generated C and editors repeat a name many times.
   *)
let most_letters = 1_000

let take_name t =
  let first = t.at and start = position t in
  while Basis.Character.is_name (peek t 0) do
    t.at <- t.at + 1
  done;
  let length = t.at - first in
  if length > most_letters then report t ~start (Long_name { most = most_letters; length });
  String.sub t.text first (min length most_letters)

(* Does this `.` select a field? There must be no space on either side, and a lower-case name must
   follow. *)
let selects t =
  Basis.Character.is_lower (peek t 1)
  && t.at > 0
  && (match t.text.[t.at - 1] with ')' | ']' | '}' | '"' -> true | c -> Basis.Character.is_name c)
  &&
  let word_start = t.at + 1 in
  let rec stop i =
    if i < String.length t.text && Basis.Character.is_name t.text.[i] then stop (i + 1) else i
  in
  match reserved (String.sub t.text word_start (stop word_start - word_start)) with
  | None | Some (QUALIFIED | AS) -> true
  | Some _ -> false

let lower t =
  let word = take_name t in
  match reserved word with Some token -> token | None -> LOWER word

let upper t =
  let word = take_name t in
  if peek t 0 <> '.' then UPPER word
  else if Basis.Character.is_upper (peek t 1) then (
    t.at <- t.at + 1;
    QUALIFIED_UPPER (word, take_name t))
  else if selects t then (
    t.at <- t.at + 1;
    QUALIFIED_LOWER (word, take_name t))
  else UPPER word

(* Reads digits in a base, with optional [_] between them. *)
let rec digits ?(base = 10) t =
  let is_digit c = match Exact.value_of_digit c with Some value -> value < base | None -> false in
  let rec after_blanks i = if peek t i = '_' then after_blanks (i + 1) else i in
  let next = if t.at > 0 && is_digit t.text.[t.at - 1] then after_blanks 0 else 0 in
  if is_digit (peek t next) then (
    t.at <- t.at + next + 1;
    digits ~base t)

(* Exact conversion takes quadratic time in the number of digits, so longer literals are rejected.
   *)
let most_digits = 1_000

(* Words that are probably a unit if they directly follow a number. *)
let is_unit = function
  | "m" | "kg" | "s" | "A" | "K" | "mol" | "cd" | "mm" | "cm" | "km" | "us" | "ms" | "min" | "hour"
  | "g" | "Hz" | "N" | "J" | "W" | "V" | "Ohm" | "Pa" | "rad" | "deg" | "rpm" ->
      true
  | _ -> false

(* Reads the rest of a unit without spaces, such as the `/s^2` in `0.3m/s^2`. *)
let rec take_rest_of_unit t =
  let part accepts =
    let rec stop i = if accepts (peek t i) then stop (i + 1) else i in
    let length = stop 1 in
    if length = 1 then ""
    else
      let text = String.sub t.text t.at length in
      t.at <- t.at + length;
      text ^ take_rest_of_unit t
  in
  match peek t 0 with
  | '/' | '*' -> part (function 'a' .. 'z' | 'A' .. 'Z' -> true | _ -> false)
  | '^' -> part Basis.Character.is_digit
  | _ -> ""

(* Is this a `.` without digits after it, as in `5. * x` or `(5.)`, where it cannot be an
   operator? *)
let lacks_fraction t =
  peek t 0 = '.'
  && match peek t 1 with ' ' | '\n' | ')' | ',' | ']' | '[' | '\000' -> true | _ -> false

let number t =
  let start = position t in
  let first = t.at in
  let base = Option.value (Exact.base_of_prefix (peek t 0, peek t 1)) ~default:10 in
  if base <> 10 then t.at <- t.at + 2;
  digits ~base t;
  let point = base = 10 && peek t 0 = '.' && Basis.Character.is_digit (peek t 1) in
  if point then (
    t.at <- t.at + 1;
    digits t);
  let exponent =
    match (peek t 0, peek t 1) with
    | ('e' | 'E'), ('+' | '-') when base = 10 ->
        if Basis.Character.is_digit (peek t 2) then 2 else 0
    | ('e' | 'E'), c when base = 10 -> if Basis.Character.is_digit c then 1 else 0
    | _ -> 0
  in
  if exponent > 0 then (
    t.at <- t.at + exponent;
    digits t);
  let text = String.sub t.text first (t.at - first) in
  if Basis.Character.is_name (peek t 0) || (base <> 10 && t.at = first + 2) then (
    let rest = take_name t in
    let has_unit = base = 10 && is_unit rest in
    let rest = if has_unit then rest ^ take_rest_of_unit t else rest in
    report t ~start (Number_followed { base; number = text; rest; has_unit });
    BAD)
  else if base = 10 && (not point) && exponent = 0 && lacks_fraction t then (
    t.at <- t.at + 1;
    report t ~start (No_fraction { number = text });
    BAD)
  else if String.length text > most_digits then (
    report t ~start (Long_number { most = most_digits; length = String.length text });
    BAD)
  else NUMBER (text, point || exponent > 0)

(* Does a value directly precede the dot, as in `x.1` or `1..2`? *)
let follows_a_value t =
  t.at > 0
  && match t.text.[t.at - 1] with ')' | ']' | '.' -> true | c -> Basis.Character.is_name c

(* Reports a literal such as `.5`, which lacks a digit before the decimal point. *)
let fraction t =
  let start = position t in
  let first = t.at in
  t.at <- t.at + 1;
  digits t;
  report t ~start (No_whole_part { fraction = String.sub t.text first (t.at - first) });
  BAD

let string t =
  let start = position t in
  let text = Buffer.create 16 in
  t.at <- t.at + 1;
  let rec go token =
    match peek t 0 with
    | '"' ->
        t.at <- t.at + 1;
        token
    | _ when at_end t || peek t 0 = '\n' ->
        report t ~start Text_not_closed;
        BAD
    | '\\' -> (
        let from = position t in
        t.at <- t.at + 1;
        let escape c =
          t.at <- t.at + 1;
          Buffer.add_char text c;
          go token
        in
        match peek t 0 with
        | '"' -> escape '"'
        | '\\' -> escape '\\'
        | 'n' -> escape '\n'
        | 't' -> escape '\t'
        | _ ->
            if (not (at_end t)) && peek t 0 <> '\n' then step t;
            report t ~start:from Unknown_escape;
            go BAD)
    | c ->
        step t;
        Buffer.add_char text c;
        go token
  in
  match go (STRING "") with STRING _ -> STRING (Buffer.contents text) | token -> token

(* {1 Symbols} *)

let unexpected t =
  let start = position t in
  let length = max 1 (fst (Utf8.decode t.text t.at)) in
  let character = String.sub t.text t.at length in
  let offset = t.at in
  for _ = 1 to length do
    step t
  done;
  let is_first = t.bad_line <> t.line in
  report t ~start (Unexpected_character { character; offset; is_first });
  t.bad_line <- t.line;
  BAD

let punctuation = function
  | "(" -> LPAREN
  | ")" -> RPAREN
  | "{" -> LBRACE
  | "}" -> RBRACE
  | "]" -> RBRACKET
  | "," -> COMMA
  | ";" -> SEMICOLON
  | "`" -> BACKTICK
  | "@" -> AT
  | "\\" -> BACKSLASH
  | "=" -> EQUAL
  | "|" -> BAR
  | "->" -> ARROW
  | "<-" -> LEFT_ARROW
  | "-<" -> TAIL
  | "=>" -> DOUBLE_ARROW
  | "::" -> DOUBLE_COLON
  | "-" -> MINUS
  | "/" -> SLASH
  | "*" -> STAR
  | "^" -> CARET
  | operator -> OPERATOR operator

let punctuation_symbols =
  [ "("; ")"; "{"; "}"; "]"; ","; ";"; "`"; "@"; "\\"; "="; "|"; "->"; "<-"; "-<"; "=>"; "::" ]

(* The symbols by their first character, longest first. *)
let symbols =
  let all = punctuation_symbols @ Operators.symbols in
  let longest_first a b = Int.compare (String.length b) (String.length a) in
  Array.init 256 (fun code ->
      List.filter (fun symbol -> Char.code symbol.[0] = code) all
      |> List.sort_uniq String.compare |> List.stable_sort longest_first
      |> List.map (fun symbol -> (symbol, punctuation symbol)))

(* Does the text at the current position match the symbol from its byte [i] onwards? *)
let rec stands_here t symbol i =
  i = String.length symbol || (peek t i = symbol.[i] && stands_here t symbol (i + 1))

let symbol t =
  let rec longest = function
    | [] -> unexpected t
    | (text, token) :: _ when stands_here t text 1 ->
        t.at <- t.at + String.length text;
        token
    | _ :: shorter -> longest shorter
  in
  longest symbols.(Char.code (peek t 0))

let bracket t =
  let tight = t.at > 0 && Basis.Character.is_name t.text.[t.at - 1] in
  t.at <- t.at + 1;
  if tight then UNIT_BRACKET else LBRACKET

let text_follows t =
  let rec from i =
    match t.text.[i] with ' ' | '\t' | '\r' | '\n' -> from (i + 1) | c -> c = '"'
  in
  try from t.at with Invalid_argument _ -> false

let next t =
  skip_blanks t;
  let start = position t in
  (* the token after an unterminated comment gets the largest possible column, so that it does not
     close any block *)
  let column = if t.cut_off then max_int else t.at - t.line_start + 1 - t.extra in
  let first = t.fresh in
  let doc =
    match t.doc with
    | [] -> None
    | lines ->
        t.doc <- [];
        Some (String.concat "\n" (List.rev lines))
  in
  t.fresh <- false;
  let token =
    if t.cut_off then (
      (* the comment may contain the code that is missing here *)
      t.cut_off <- false;
      BAD)
    else if at_end t then END
    else
      match peek t 0 with
      | c when Basis.Character.is_lower c -> lower t
      | c when Basis.Character.is_upper c -> upper t
      | c when Basis.Character.is_digit c -> number t
      | '"' -> string t
      | '\\' when stands_here t "\\case" 1 && not (Basis.Character.is_name (peek t 5)) ->
          t.at <- t.at + 5;
          LAMBDA_CASE
      | '[' -> bracket t
      | '.' when selects t ->
          t.at <- t.at + 1;
          FIELD (take_name t)
      | '.' when Basis.Character.is_digit (peek t 1) && not (follows_a_value t) -> fraction t
      | _ -> symbol t
  in
  { token; start; stop = position t; column; first; doc }
