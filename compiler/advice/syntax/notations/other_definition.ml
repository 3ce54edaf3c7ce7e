open Basis

type t = { head : int * int; signature : string option; equation : string }

let char_at text i = if i >= 0 && i < String.length text then text.[i] else '\000'
let sub text first last = String.sub text first (max 0 (last - first))

let end_of_line text at =
  Option.value (String.index_from_opt text at '\n') ~default:(String.length text)

let is_word text =
  text <> "" && (not (Character.is_digit text.[0])) && String.for_all Character.is_name text

(* {1 Parts of a definition} *)

let type_of = function
  | "float" | "double" -> Some "Float"
  | "int" | "long" | "short" | "unsigned" | "size_t" | "uint8_t" | "uint16_t" | "int16_t"
  | "int32_t" | "uint32_t" | "byte" ->
      Some "Int"
  | "bool" | "boolean" -> Some "Bool"
  | _ -> None

let words text = List.filter (( <> ) "") (String.split_on_char ' ' (String.trim text))
let is_qualifier word = List.mem word [ "static"; "inline"; "const"; "constexpr"; "extern" ]

(* The type and the name in `const float x`. *)
let typed text =
  match List.filter (fun word -> not (is_qualifier word)) (words text) with
  | [ type_; name ] when is_word name -> Option.map (fun t -> (t, name)) (type_of type_)
  | _ -> None

let all options = if List.mem None options then None else Some (List.filter_map Fun.id options)

(* The name, the text in the parentheses, and the offset after them, in `f(x, y)`. *)
let called text first last =
  match String.index_from_opt text first '(' with
  | Some opening when opening < last -> (
      match String.index_from_opt text opening ')' with
      | Some closing when closing < last ->
          Some (String.trim (sub text first opening), sub text (opening + 1) closing, closing + 1)
      | _ -> None)
  | _ -> None

let split_commas text =
  if String.trim text = "" then [] else List.map String.trim (String.split_on_char ',' text)

let left name parameters = String.concat " " (name :: parameters)

let equation name parameters body =
  Printf.sprintf "%s = %s" (left name parameters) (Option.value body ~default:"…")

let without_semicolon text =
  let text = String.trim text in
  let n = String.length text in
  if n > 0 && text.[n - 1] = ';' then String.trim (String.sub text 0 (n - 1)) else text

(* The expression in a body that consists of a single `return`. *)
let returned body =
  let body = without_semicolon body in
  let prefix = "return" in
  let n = String.length prefix in
  if
    String.starts_with ~prefix body
    && (not (String.contains body ';'))
    && not (Character.is_name (char_at body n))
  then Other_notation.expression (sub body n (String.length body))
  else None

(* {1 Functions} *)

let of_c text at =
  let stop = end_of_line text at in
  match called text at stop with
  | None -> None
  | Some (before, inside, closing) -> (
      let ends =
        match String.trim (sub text closing stop) with "" -> true | rest -> rest.[0] = '{'
      in
      match (typed before, all (List.map typed (split_commas inside))) with
      | Some (result, name), Some parameters when ends ->
          let body =
            match String.index_from_opt text closing '{' with
            | Some opening when String.trim (sub text closing opening) = "" ->
                Option.bind (String.index_from_opt text opening '}') (fun last ->
                    returned
                      (String.concat " " (String.split_on_char '\n' (sub text (opening + 1) last))))
            | _ -> None
          in
          let types = List.map fst parameters @ [ result ] in
          Some
            {
              head = (at, closing);
              signature = Some (Printf.sprintf "%s :: %s" name (String.concat " -> " types));
              equation = equation name (List.map snd parameters) body;
            }
      | _ -> None)

(* `square(x) { return x * x; }`, without types *)
let of_javascript text at =
  let open Basis.Let_syntax.Option in
  let stop = end_of_line text at in
  let* name, inside, closing = called text at stop in
  let* parameters =
    all (List.map (fun p -> if is_word p then Some p else None) (split_commas inside))
  in
  let opening =
    let rec skip i = match char_at text i with ' ' | '\n' -> skip (i + 1) | _ -> i in
    skip closing
  in
  if (not (is_word name)) || char_at text opening <> '{' then None
  else
    let* last = String.index_from_opt text opening '}' in
    let lines = String.split_on_char '\n' (sub text (opening + 1) last) in
    let* body = returned (String.concat " " lines) in
    Some { head = (at, closing); signature = None; equation = equation name parameters (Some body) }

(* The indented lines below the line that ends at this offset. *)
let below text stop =
  let rec lines start found =
    if start >= String.length text then List.rev found
    else
      let stop = end_of_line text start in
      let line = sub text start stop in
      if String.trim line <> "" && line.[0] <> ' ' then List.rev found
      else lines (stop + 1) (if String.trim line = "" then found else line :: found)
  in
  lines (stop + 1) []

(* `x` for the parameter `x: float = 1`. *)
let name_of_parameter text =
  let first c text = String.trim (List.hd (String.split_on_char c text)) in
  let name = first ':' (first '=' text) in
  if is_word name then Some name else None

let after_word text at word =
  let n = String.length word in
  if String.equal (sub text at (min (String.length text) (at + n))) word then Some (at + n)
  else None

let of_python text at =
  let stop = end_of_line text at in
  match Option.bind (after_word text at "def ") (fun first -> called text first stop) with
  | Some (name, inside, closing) when is_word name -> (
      match all (List.map name_of_parameter (split_commas inside)) with
      | None -> None
      | Some parameters ->
          let on_line =
            match String.index_from_opt text closing ':' with
            | Some colon when colon < stop -> String.trim (sub text (colon + 1) stop)
            | _ -> ""
          in
          let body =
            match (on_line, below text stop) with
            | "", [ line ] -> returned line
            | "", _ -> None
            | line, _ -> returned line
          in
          Some { head = (at, closing); signature = None; equation = equation name parameters body })
  | _ -> None

(* The name and the value in `y = x * 2;`. *)
let assigned line =
  let line = without_semicolon line in
  match String.index_opt line '=' with
  | Some i when char_at line (i + 1) <> '=' ->
      let name = String.trim (sub line 0 i) in
      if is_word name then
        Option.map
          (fun value -> (name, value))
          (Other_notation.expression (sub line (i + 1) (String.length line)))
      else None
  | _ -> None

let of_matlab text at =
  let stop = end_of_line text at in
  let first =
    Option.bind (after_word text at "function ") (fun first ->
        match String.index_from_opt text first '=' with
        | Some equals when equals < stop -> Some (String.trim (sub text first equals), equals + 1)
        | _ -> None)
  in
  match first with
  | None -> None
  | Some (result, after) -> (
      match called text after stop with
      | Some (name, inside, closing) when is_word name && is_word result -> (
          match all (List.map name_of_parameter (split_commas inside)) with
          | None -> None
          | Some parameters ->
              let body =
                match List.map assigned (below text stop) with
                | [ Some (name, value) ] when String.equal name result -> Some value
                | _ -> None
              in
              Some
                { head = (at, closing); signature = None; equation = equation name parameters body }
          )
      | _ -> None)

let of_main =
  "define `main` by an equation: `main = reactimateRobot (proc i -> …)` for a robot that follows \
   signals, or `main = reactimateTask t` for one that runs a task `t`"

let advice t =
  match t.signature with
  | _ when String.starts_with ~prefix:"main " t.equation -> of_main
  | Some signature ->
      Printf.sprintf "write a signature, `%s`, and below it an equation, `%s`" signature t.equation
  | None -> Printf.sprintf "define a function by an equation: `%s`" t.equation

(* {1 Choices} *)

(* The text in the parentheses that begin at or after this offset, and the offset after them. *)
let in_parentheses text at =
  let rec close i depth =
    match char_at text i with
    | '\000' | '\n' -> None
    | '(' -> close (i + 1) (depth + 1)
    | ')' -> if depth = 1 then Some i else close (i + 1) (depth - 1)
    | _ -> close (i + 1) depth
  in
  if char_at text at = '(' then
    Option.map (fun stop -> (sub text (at + 1) stop, stop + 1)) (close at 0)
  else None

let rec skip_blanks text i =
  match char_at text i with ' ' | '\n' -> skip_blanks text (i + 1) | _ -> i

(* The condition and the offset after its colon, or after its parentheses and `{`. *)
let condition text at =
  let stop = end_of_line text at in
  let of_python =
    match String.index_from_opt text at ':' with
    | Some colon when colon < stop -> Some (sub text at colon, colon + 1)
    | _ -> None
  in
  let line = sub text at stop in
  match in_parentheses text at with
  | Some (inside, after) when char_at text (skip_blanks text after) = '{' ->
      Some (inside, skip_blanks text after + 1)
  | Some (inside, after) when Character.is_lower (char_at text (skip_blanks text after)) ->
      Some (inside, after)
  | _ when of_python = None && not (List.mem "then" (words line) || String.contains line '=') ->
      Some (line, stop)
  | _ -> of_python

(* The assignment at this offset, and the offset after it. *)
let assignment text at =
  let at = skip_blanks text at in
  let stop = end_of_line text at in
  let last =
    match String.index_from_opt text (min at (String.length text)) '}' with
    | Some brace when brace < stop -> brace
    | _ -> stop
  in
  Option.map (fun it -> (it, last)) (assigned (sub text at last))

let after_brace text at =
  let at = skip_blanks text at in
  if char_at text at = '}' then skip_blanks text (at + 1) else at

let keyword text at words =
  List.find_map
    (fun word ->
      match after_word text at word with
      | Some after when not (Character.is_name (char_at text after)) ->
          Some (skip_blanks text after)
      | _ -> None)
    words

(* The branches of the choice whose condition begins at this offset, and the value after `else`, or
   `…` if there is no `else`. *)
let rec branches assignment text at =
  let open Basis.Let_syntax.Option in
  let* given, after = condition text at in
  let* given = Other_notation.expression given in
  let* assigned, after = assignment text after in
  let next = after_brace text after in
  match keyword text next [ "elif"; "elseif"; "else if" ] with
  | Some next ->
      let* others, last = branches assignment text next in
      Some ((given, assigned) :: others, last)
  | None when keyword text next [ "else" ] = None ->
      Some ([ (given, assigned) ], (fst assigned, "…"))
  | None ->
      let* next = keyword text next [ "else" ] in
      let next = if List.mem (char_at text next) [ ':'; '{' ] then next + 1 else next in
      let* last, _ = assignment text next in
      Some ([ (given, assigned) ], last)

let choice text at =
  match Option.bind (keyword text at [ "if" ]) (branches assignment text) with
  | Some (branches, (name, last))
    when List.for_all (fun (_, (other, _)) -> String.equal other name) branches ->
      let part (given, (_, value)) = Printf.sprintf "if %s then %s else " given value in
      Some (Printf.sprintf "%s = %s%s" name (String.concat "" (List.map part branches)) last)
  | _ -> None

(* The value on the line at this offset, with or without a `return` before it, and the offset of the
   end of the line. *)
let value_of_branch text at =
  let at = skip_blanks text at in
  let stop = end_of_line text at in
  let line = without_semicolon (sub text at stop) in
  let value =
    match words line with
    | "return" :: _ -> sub line (String.length "return") (String.length line)
    | _ -> line
  in
  Option.map (fun value -> (("", value), stop)) (Other_notation.expression value)

let choice_of_values text at =
  match Option.bind (keyword text at [ "if" ]) (branches value_of_branch text) with
  | Some (_, (_, "…")) | None -> None
  | Some (branches, (_, last)) ->
      let part (given, (_, value)) = Printf.sprintf "if %s then %s else " given value in
      Some (String.concat "" (List.map part branches) ^ last)

(* The text in the braces at or after this offset, and the offset after them. *)
let in_braces text at =
  let at = skip_blanks text at in
  let rec close i depth =
    match char_at text i with
    | '\000' -> None
    | '{' -> close (i + 1) (depth + 1)
    | '}' -> if depth = 1 then Some i else close (i + 1) (depth - 1)
    | _ -> close (i + 1) depth
  in
  if char_at text at = '{' then
    Option.map (fun stop -> (String.trim (sub text (at + 1) stop), stop + 1)) (close at 0)
  else None

let choice_in_braces text at =
  let open Basis.Let_syntax.Option in
  let* at = keyword text at [ "if" ] in
  let* opening = String.index_from_opt text at '{' in
  let* given = Other_notation.expression (sub text at opening) in
  let* first, after = in_braces text opening in
  let* first = Other_notation.expression (without_semicolon first) in
  let* next = keyword text (skip_blanks text after) [ "else" ] in
  let* second, _ = in_braces text next in
  let* second = Other_notation.expression (without_semicolon second) in
  Some (Printf.sprintf "if %s then %s else %s" given first second)

(* {1 Types} *)

let non_empty texts = List.filter (( <> ) "") (List.map String.trim texts)
let lines_joined text = String.concat " " (String.split_on_char '\n' text)

(* The Frob type for a field's type in another language. A capitalized name is probably already a
   Frob type. *)
let type_of_field text =
  let text = String.trim text in
  let is_part c = Character.is_name c || List.mem c [ ' '; '['; ']'; '/'; '^' ] in
  match text with
  | "f32" | "f64" | "number" -> Some "Float"
  | "i8" | "i16" | "i32" | "i64" | "u8" | "u16" | "u32" | "u64" | "usize" | "Integer" -> Some "Int"
  | "Boolean" -> Some "Bool"
  | "" -> None
  | _ when type_of text <> None -> type_of text
  | _ when Character.is_upper text.[0] && String.for_all is_part text -> Some text
  | _ -> None

(* `x :: Float` for `x : float`; both `x :: Float` and `y :: Float` for `float x, y`. *)
let fields_of_declaration text =
  let field name type_ =
    let name = String.trim name in
    if is_word name && Character.is_lower name.[0] then
      Option.map (Printf.sprintf "%s :: %s" name) (type_of_field type_)
    else None
  in
  match String.split_on_char ':' text with
  | [ name; type_ ] -> [ field name type_ ]
  | [ _ ] -> (
      match List.filter (fun word -> not (is_qualifier word)) (words text) with
      | type_ :: (_ :: _ as names) ->
          List.map (fun name -> field name type_) (split_commas (String.concat " " names))
      | _ -> [ None ])
  | _ -> [ None ]

let words_of_a_record = [ "struct"; "typedef"; "type"; "alias"; "record"; "interface"; "pub"; "=" ]

(* The text without C comments at the ends of its lines. *)
let without_comments text =
  let rec until i line =
    if i + 1 >= String.length line then line
    else if line.[i] = '/' && line.[i + 1] = '/' then String.sub line 0 i
    else until (i + 1) line
  in
  String.concat "\n" (List.map (until 0) (String.split_on_char '\n' text))

let record text at =
  let open Basis.Let_syntax.Option in
  let* opening = String.index_from_opt text at '{' in
  let before =
    List.filter
      (fun word -> not (List.mem word words_of_a_record))
      (words (lines_joined (sub text at opening)))
  in
  let* inside, after = in_braces text opening in
  let following = without_semicolon (sub text after (end_of_line text after)) in
  let* name =
    match before with
    | _ when is_word following -> Some following
    | [ name ] -> Some name
    | _ -> None
  in
  let separator = if String.contains inside ':' then ',' else ';' in
  let inside = lines_joined (without_comments inside) in
  let declarations = non_empty (String.split_on_char separator inside) in
  let* fields = all (List.concat_map fields_of_declaration declarations) in
  if fields = [] || not (is_word name) then None
  else
    let name = String.capitalize_ascii name in
    Some (Printf.sprintf "data %s = %s { %s }" name name (String.concat ", " fields))

let enumeration text at =
  let open Basis.Let_syntax.Option in
  let* opening = String.index_from_opt text at '{' in
  let* name = match List.rev (words (sub text at opening)) with n :: _ -> Some n | [] -> None in
  let* inside, _ = in_braces text opening in
  let names = non_empty (String.split_on_char ',' (lines_joined inside)) in
  if names = [] || not (List.for_all is_word (name :: names)) then None
  else
    let names = List.map String.capitalize_ascii names in
    Some (Printf.sprintf "data %s = %s" (String.capitalize_ascii name) (String.concat " | " names))

let array text at =
  let open Basis.Let_syntax.Option in
  let stop = end_of_line text at in
  let* bracket = String.index_from_opt text at '[' in
  let* closing = String.index_from_opt text bracket ']' in
  if closing > stop then None
  else
    let* type_, name = typed (sub text at bracket) in
    let* equals = String.index_from_opt text closing '=' in
    let* inside, _ = if equals < stop then in_braces text (equals + 1) else None in
    let values = non_empty (String.split_on_char ',' (lines_joined inside)) in
    Some
      (Printf.sprintf "write `%s :: Array %d %s`, and below it `%s = [%s]`" name
         (List.length values) type_ name (String.concat ", " values))

(* {1 Lambdas} *)

let body_of_lambda text at =
  let stop = end_of_line text at in
  let rec last i depth =
    if i >= stop then i
    else
      match text.[i] with
      | '(' | '[' -> last (i + 1) (depth + 1)
      | ')' | ']' -> if depth = 0 then i else last (i + 1) (depth - 1)
      | ',' when depth = 0 -> i
      | _ -> last (i + 1) depth
  in
  Other_notation.expression (sub text at (last at 0))
