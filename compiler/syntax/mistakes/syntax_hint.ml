open Basis
open Grammar
open Found

let reserved_word = Printf.sprintf "`%s` is a word of the language and cannot be a name"

(* {1 Indentation} *)

let items : Layout.block -> string = function
  | Top | Let | Where -> "definitions"
  | Do | Rec -> "statements"
  | Of -> "branches"

(* The column of the first token of the line on which the found one stands. *)
let line_column found =
  let bol = found.token.start.pos_bol in
  let rec go i = if is_blank (char_at found i) && char_at found i <> '\n' then go (i + 1) else i in
  go bol - bol + 1

let misplaced_line found =
  match innermost found.context with
  | Some (Let, { column; _ })
    when found.token.first && found.token.column > 1 && found.token.column < column ->
      Some
        (Printf.sprintf
           "`in` comes before the expression, as in `let x = 1 in x + x`; one more definition \
            starts at column %d"
           column)
  | Some (((Where | Do | Of | Rec) as block), { column; _ })
    when found.token.first && found.token.column > 1 && found.token.column < column ->
      Some
        (Printf.sprintf "the %s of this block start at column %d, but this line at column %d"
           (items block) column found.token.column)
  | Some (block, { column; _ }) when (not found.token.first) && line_column found > column -> (
      match (found.token.token, block) with
      | (EQUAL | DOUBLE_COLON), (Top | Let | Where) | ARROW, Of | (LEFT_ARROW | TAIL), (Do | Rec) ->
          let line_start = found.token.start.pos_bol in
          (* the block opens on this line, or the item starts there *)
          let own_line =
            match found.context with
            | (_, { by; _ }) :: _ -> by.start.pos_bol = line_start
            | [] -> false
          in
          if own_line then None
          else
            Some
              (Printf.sprintf
                 "the %s of this block start at column %d; this line stands further right, so it \
                  goes on with the one above%s"
                 (items block) column
                 (if found.token.token = EQUAL && opens_with (Layout.Block Top) found.context then
                    ", unless a `where` ends that"
                  else ""))
      | _ -> None)
  | Some _ | None -> None

(* {1 By the token} *)

let by_indentation = "blocks are made by indentation; braces write records only"

let assigns found =
  match found.before with
  | Some { token = OPERATOR "!"; _ } -> Some "`/=` says that two values differ"
  | Some { token = OPERATOR "+" | MINUS | STAR | SLASH; _ } ->
      Some
        "nothing is assigned: an equation says what holds at every instant, as in `n = delay 0 n + \
         1`"
  | Some _ | None -> None

(* Directly after `{` or `,`, a field of a value; elsewhere one of a declaration. *)
let field_of_a_value found (field : Layout.token) =
  let rec back i = if is_blank (char_at found i) && i >= 0 then back (i - 1) else char_at found i in
  match back (field.start.pos_cnum - 1) with '{' | ',' -> true | _ -> false

let own_operator =
  "programs define no operators; a function stands between in backticks: ``a `f` b``"

(* The line up to here has this word. *)
let names_before found word =
  let start = found.token.start.pos_bol in
  let line = String.sub found.text start (found.token.start.pos_cnum - start) in
  List.mem word (String.split_on_char ' ' line)

(* An operator of other languages, of which the first characters are one of Frob's. *)
let foreign_operator found (before : Layout.token) =
  if not (is_adjacent found before) then None
  else
    match written found before ^ written found found.token with
    | "<$" | "<*" ->
        Some "`mapE f e` applies a function to an event's value, `map f xs` to each of an array"
    | ".^" | ".*" | "./" ->
        Some
          "operators are of numbers: `map (\\x -> x ^ 2) xs` computes with each of an array, \
           `zipWith (*) xs ys` with those of two"
    | "<>" -> Some "`/=` says that two values differ"
    | text when String.length text > 1 && text.[0] = '|' && is_symbol text.[1] -> Some own_operator
    | ">>" | ">>=" -> Some "tasks follow one another in a `do`, each on a line of its own"
    | "++" when after found = ' ' ->
        Some "nothing is joined: a text is a label, and an array has a fixed size"
    | "++" ->
        Some
          "nothing is counted up: an equation says what holds at every instant, as in `n = delay 0 \
           n + 1`"
    | "!!" ->
        Some "an element of an array is written `xs ! 0`, and `at i default xs` takes any index"
    | "/*" -> Some "a comment is written `{- … -}`, or `--` up to the end of the line"
    | "//" -> Some "a comment starts with `--`; whole numbers are divided by `div`"
    | ".." when names_before found "seeds" -> Some "they are ``1 `to` 20``, both included"
    | ".." ->
        Some
          "there are no ranges: a few elements are written out, `[1, 2, 3]`; many are made by the \
           index, `generate (\\i -> i + 1)`, as many as the type says"
    | _ -> None

(* What follows an opening brace in its line: `name =`, as in a value, or `name ::`, as in
   a type. *)
let opens_fields found sign =
  let rec skip accepts i =
    if accepts (char_at found i) && i < String.length found.text then skip accepts (i + 1) else i
  in
  let is_letter = function
    | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true
    | _ -> false
  in
  let name = skip (fun c -> c = ' ') found.token.stop.pos_cnum in
  let stop = skip is_letter name in
  let at = skip is_blank stop in
  stop > name
  && at + String.length sign <= String.length found.text
  && String.equal (String.sub found.text at (String.length sign)) sign

(* The first line of the definition, up to what does not belong there. *)
let head_of_definition found =
  let start = start_of_definition found in
  if found.token.start.pos_bol = start then between found start found.token.start.pos_cnum
  else String.trim (first_line_of_definition found)

let lacks_where found =
  match String.split_on_char ' ' (first_line_of_definition found) with
  | ("class" | "instance") :: words -> not (List.mem "where" words)
  | _ -> false

(* `Robot (setVelTR)`, of `from Robot import setVelTR`. *)
let python_import found =
  let bol = found.token.start.pos_bol in
  let module_ = between found bol found.token.start.pos_cnum in
  let module_ = String.trim (String.sub module_ 4 (String.length module_ - 4)) in
  let names =
    between found found.token.stop.pos_cnum (end_of_line found found.token.stop.pos_cnum)
  in
  let is_name =
    String.for_all (function
      | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | ',' | ' ' -> true
      | _ -> false)
  in
  if module_ = "" || not (is_name module_) then "Control (limit)"
  else
    let module_ = String.capitalize_ascii module_ in
    if names = "" || not (is_name names) then module_ else Printf.sprintf "%s (%s)" module_ names

(* The line of the definition or this one, if it begins as in other languages, and what is
   said of that. *)
let beginning found =
  let start = found.token.start in
  let bol = start_of_definition found in
  let above = String.split_on_char '\n' (String.sub found.text bol (start.pos_cnum - bol)) in
  let definition =
    { start with pos_bol = bol; pos_lnum = start.pos_lnum + 1 - List.length above }
  in
  match part found (word_from found bol) with
  | "void" -> Some (definition, Beginnings.no_procedures)
  | "function" -> Some (definition, Beginnings.by_equation)
  | "from" when found.token.token = IMPORT ->
      Some (start, Printf.sprintf "names are imported by `import %s`" (python_import found))
  | _ ->
      let word = part found (first_word_from found start.pos_bol) in
      Option.map (fun hint -> (start, hint)) (Beginnings.of_word word)

(* [MyRobot] of `my-robot`, which begins with the token. *)
let module_name found =
  let is_part c =
    match c with 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '-' -> true | _ -> false
  in
  let rec stop i = if is_part (char_at found i) then stop (i + 1) else i in
  let start = found.token.start.pos_cnum in
  String.split_on_char '-' (String.sub found.text start (stop start - start))
  |> List.map String.capitalize_ascii |> String.concat ""

let capital found =
  let name = module_name found in
  Some
    (Printf.sprintf "a module begins with a capital, and its file too: `%s`, in `%s.frob`" name name)

(* {1 In the program's own words} *)

(* [2 * x | x <- xs] *)
let comprehension found =
  match found.context with
  | (Bracket, { by; _ }) :: _ -> (
      let end_ = end_of_line found found.token.start.pos_cnum in
      let rest = between found found.token.stop.pos_cnum end_ in
      let element = between found by.stop.pos_cnum found.token.start.pos_cnum in
      match String.split_on_char '<' rest with
      | [ x; source ] when source <> "" && source.[0] = '-' -> (
          let x = String.trim x in
          match String.split_on_char ']' (String.sub source 1 (String.length source - 1)) with
          | xs :: _ :: _ when x <> "" && not (String.contains xs ',') ->
              Some
                (Printf.sprintf "each element of an array is computed with by `map (\\%s -> %s) %s`"
                   x element
                   (Source.grouped (String.trim xs)))
          | _ -> Some "each element of an array is computed with by `map (\\x -> …) xs`")
      | _ -> None)
  | _ -> None

(* The `case` of which the line ends without `of`. *)
let lacks_of found =
  match found.context with
  | (Case, { by; _ }) :: _ when by.start.pos_lnum <> found.token.start.pos_lnum ->
      let line = between found by.stop.pos_cnum (end_of_line found by.stop.pos_cnum) in
      let line =
        match String.index_opt line ':' with
        | Some colon when colon = String.length line - 1 -> String.trim (String.sub line 0 colon)
        | _ -> line
      in
      if line = "" || String.length line > 40 then None
      else Some (Printf.sprintf "the line of the `case` ends with `of`: `case %s of`" line)
  | _ -> None

let no_equation_before_guards =
  "leave out the `=` before the guards: each of them has its own, as in `| x > 0 = 1`"

(* The name before `.speed`. *)
let record_before found (field : Layout.token) =
  match word_before found field.start.pos_cnum with "" -> "r" | name -> name

let is_a_unit : Layout.context -> bool = function
  | (Bracket, { by = { token = UNIT_BRACKET; _ }; _ }) :: _ -> true
  | _ -> false

(* The `do` around is that of a `proc`, of which the statements are no tasks. *)
let of_a_proc found =
  match innermost found.context with
  | Some (Do, { by; _ }) ->
      let line = between found by.start.pos_bol by.start.pos_cnum in
      List.mem "proc" (String.split_on_char ' ' (String.concat " " (String.split_on_char '(' line)))
  | _ -> false

(* Another bar follows, and this one touches what is between them. *)
let encloses found =
  (not (is_blank (after found) || is_symbol (after found)))
  && String.contains
       (between found found.token.stop.pos_cnum (end_of_line found found.token.stop.pos_cnum))
       '|'

(* `f (v = 1)` *)
let is_a_keyword_argument found (name : Layout.token) =
  opens_with Layout.Paren found.context
  &&
  let rec back i = if i >= 0 && char_at found i = ' ' then back (i - 1) else i in
  let opener = back (name.start.pos_cnum - 1) in
  match char_at found opener with
  | '(' -> (
      match char_at found (back (opener - 1)) with
      | 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true
      | _ -> false)
  | ',' -> true
  | _ -> false

let opens_block : Layout.token option -> bool = function
  | Some { token = OPEN; _ } -> true
  | Some _ | None -> false

let is_local : Layout.block -> bool = function Where | Let | Do | Rec -> true | Top | Of -> false

(* `param speed :: Velocity`, or `foreign cbrt :: Float -> Float`, without what it is by default,
   or its name in C. *)
let lacks_a_value found =
  let line = String.trim (first_line_of_definition found) in
  let words = String.split_on_char ' ' line in
  match words with
  | ("param" | "foreign") :: rest
    when String.length line > 50 || String.contains line '=' || not (List.mem "::" rest) ->
      None
  | "param" :: _ -> Some (Printf.sprintf "what it is by default stands behind: `%s = …`" line)
  | "foreign" :: ("type" | "include" | "sf") :: _ -> None
  | "foreign" :: name :: _ ->
      Some (Printf.sprintf "its name in C stands behind: `%s = \"%s\"`" line name)
  | _ -> None

(* `Float - > Float` *)
let splits_an_arrow found =
  let stop = found.token.stop.pos_cnum in
  is_blank (char_at found stop)
  && char_at found (stop + 1) = '>'
  && is_blank (char_at found (stop + 2))

(* `f :: Float, Float -> Float` *)
let lists_parameters found =
  let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
  List.mem "::" (String.split_on_char ' ' line)
  && (not (String.contains line '='))
  && not (in_brackets found.context)

(* The line is a signature up to here, and an array is the last in it. *)
let is_in_a_size found =
  let line = between found found.token.start.pos_bol found.token.start.pos_cnum in
  let words = String.split_on_char ' ' (String.concat " " (String.split_on_char '(' line)) in
  List.mem "::" words
  && (not (List.mem "=" words))
  && match List.filter (( <> ) "") (List.rev words) with _ :: "Array" :: _ -> true | _ -> false

let of_token found =
  match (found.token.token, found.before) with
  | _ when beginning found <> None -> Option.map snd (beginning found)
  | _, Some before when foreign_operator found before <> None -> foreign_operator found before
  | (LOWER _ | STRING _ | SLASH | OPERATOR "."), Some { token = IMPORT | QUALIFIED; _ }
    when Lacking.path found <> None ->
      Lacking.path found
  | LOWER _, Some { token = MODULE | IMPORT | QUALIFIED; _ } -> capital found
  | LOWER _, Some _ when Lacking.choices found <> None -> Lacking.choices found
  | ( QUALIFIED_UPPER (("Data" | "Control" | "Prelude" | "Math" | "System" | "Text" | "GHC"), _),
      Some { token = IMPORT | QUALIFIED; _ } ) ->
      Some
        "what that has for lists, numbers and choices is there without an import, as `map`, \
         `foldl`, `maybe`; the modules of the library are `Control`, `Geometry`, `Robot` and \
         others, without points"
  | QUALIFIED_UPPER _, Some { token = IMPORT | QUALIFIED; _ } ->
      Some "the name of a module has no points: its file stands beside this one, or in the library"
  | LOWER _, Some _ when first_word found = "import" && written found found.token = "hiding" ->
      Some
        "nothing needs hiding: a module's own definitions hide imported ones, and two imports of \
         one name clash only where it is used"
  | BAR, Some ({ token = LOWER _; _ } as before) when written found before = "with" ->
      Some "a choice by constructors is written `case x of`, and each branch `pattern -> value`"
  | IF, Some before when (not (expects_more (Some before))) && not found.token.first ->
      Some "a choice is written `if c then a else b`"
  | DOUBLE_ARROW, Some _ when innermost_block found.context = Of ->
      Some "a branch is written `pattern -> value`"
  | LEFT_ARROW, _ when not (is_blank (after found)) ->
      Some "`<-` is always one symbol; to compare with a negative number write `< -` with a blank"
  | LEFT_ARROW, _ when innermost_block found.context <> Do ->
      Some "`<-` belongs to the statements of a `do`; an equation is written with `=`"
  | TAIL, _ ->
      Some "`-<` belongs to `proc`; in an equation a signal function is just applied: `x = sf e`"
  | ( (EQUAL | DOUBLE_COLON),
      Some
        ({
           token =
             ( UNIT | PRIMITIVE | FOREIGN | PARAM | CLASS | INSTANCE | DATA | TYPE | MODULE | IMPORT
             | REC );
           _;
         } as word) ) ->
      Some (reserved_word (written found word))
  | (EQUAL | BAR | DOUBLE_COLON), _ when lacks_where found ->
      Some
        (Printf.sprintf "the methods follow `where`, each on a line of its own: `%s where`"
           (head_of_definition found))
  | BAR, Some { token = UPPER _ | LOWER _; _ } when first_word found = "type" ->
      let start = found.token.start.pos_bol + 4 in
      Some
        (Printf.sprintf "a choice of several is declared by `data`: `data %s`"
           (between found start (end_of_line found start)))
  | COMMA, Some { token = NUMBER _; _ } when names_before found "!" ->
      Some "an element of a row is reached by one `!` after the other: `m ! 0 ! 1`"
  | IMPORT, Some { token = FOREIGN; _ } ->
      Some "the name in C stands last: `foreign cubeRoot :: Float -> Float = \"cbrt\"`"
  | (END | SEMICOLON), Some _ when lacks_a_value found <> None -> lacks_a_value found
  | LOWER _, Some { token = DATA | TYPE | CLASS; _ } ->
      Some
        (Printf.sprintf "the name of a type or class starts with a capital: `%s`"
           (String.capitalize_ascii (written found found.token)))
  | EQUAL, Some { token = UPPER _ | NUMBER _ | UNDERSCORE | RPAREN; _ }
    when innermost_block found.context = Of && not (in_brackets found.context) ->
      Some
        (Printf.sprintf "a branch has `->`: `%s -> …`"
           (between found found.token.start.pos_bol found.token.start.pos_cnum))
  | MINUS, Some { token = UPPER _ | LOWER _ | RPAREN | RBRACKET; _ } when splits_an_arrow found ->
      Some "`->` is always one symbol"
  | COMMA, Some _ when lists_parameters found ->
      Some
        "each parameter is followed by `->`, as in `Float -> Float -> Float`; a tuple stands in \
         parentheses"
  | (NUMBER _ | LOWER _ | UPPER _ | LPAREN), Some { token = LBRACE; _ }
    when List.exists (fun (opener, _) -> opener = Layout.If) found.context ->
      Some "a choice is written `if c then a else b`, without braces"
  | EQUAL, Some before when is_adjacent found before && assigns found <> None -> assigns found
  | EQUAL, Some ({ token = LOWER _; _ } as name)
    when stands_after found "then" name || stands_after found "else" name ->
      Some "nothing is assigned: one equation chooses the value, as in `x = if c then a else b`"
  | EQUAL, Some ({ token = LOWER _; _ } as name) when is_a_keyword_argument found name ->
      Some "arguments have no names: they stand side by side in their order, as in `f 1 2`"
  | EQUAL, Some ({ token = FIELD field; _ } as before) ->
      Some
        (Printf.sprintf "no record is changed: `%s { %s = … }` is one with another `%s`"
           (record_before found before) field field)
  | EQUAL, Some ({ token = LOWER _; _ } as name)
    when innermost_block found.context = Do
         && (not (in_brackets found.context))
         && not (of_a_proc found) ->
      let name = written found name in
      Some
        (Printf.sprintf
           "`%s <- t` does the task `t` and names what it ends with; `let %s = e` names a value"
           name name)
  | (NUMBER _ | MINUS | STRING _ | LPAREN), Some { token = LBRACE | COMMA; _ }
    when opens_with Layout.Brace found.context ->
      Some "each value stands behind the name of its field: `Pose { heading = 0 }`"
  | FIELD _, Some _ when is_a_unit found.context ->
      Some "a blank or `*` multiplies units, as in `kg m^2`"
  | EQUAL, _ when compares found.context -> Some "`=` defines; to compare write `==`"
  | DOUBLE_COLON, Some { token = UPPER _; _ } ->
      Some "the name of a value starts with a small letter"
  | EQUAL, Some _ when opens_with Layout.Brace found.context ->
      Some "there is a `,` between two fields"
  | DOUBLE_COLON, Some field when opens_with Layout.Brace found.context ->
      if field_of_a_value found field then Some "a field gets its value with `=`"
      else Some "there is a `,` between two fields"
  | ( DO,
      Some
        {
          token = LOWER _ | UPPER _ | NUMBER _ | RPAREN | RBRACKET | QUALIFIED_LOWER _ | FIELD _;
          _;
        } ) ->
      Some "a `do` among arguments needs parentheses, or a `$` before it"
  | ( (BACKSLASH | LAMBDA_CASE),
      Some
        {
          token = LOWER _ | UPPER _ | NUMBER _ | RPAREN | RBRACKET | QUALIFIED_LOWER _ | FIELD _;
          _;
        } ) ->
      Some "a lambda among arguments needs parentheses: `f (\\x -> …)`"
  | LBRACE, Some { token = OPEN; _ } -> Some by_indentation
  | (LOWER _ | UPPER _ | NUMBER _ | LPAREN), Some { token = LOWER _; _ }
    when opens_with Layout.Brace found.context ->
      Some "a field gets its value with `=`; if a block was meant, it is made by indentation"
  | (LOWER _ | NUMBER _ | UNDERSCORE | LPAREN), Some ({ token = UPPER _; _ } as constructor)
    when stands_after found "proc" constructor ->
      Some "a pattern such as `Just x` needs parentheses here"
  | ELSE, Some { token = BAR; _ } -> Some "what holds for the rest is written `| otherwise`"
  | ELSE, _ when opens_with Layout.If found.context ->
      Some "`then` stands between the condition and the first choice: `if c then a else b`"
  | THEN, _ when opens_with Layout.Then found.context ->
      Some "a chain of choices is written `if a then x else if b then y else z`"
  | BAR, _ when comprehension found <> None -> comprehension found
  | ARROW, Some ({ token = LOWER _; _ } as name)
    when is_adjacent found name && not (is_blank (after found)) ->
      Some
        "nothing is reached by `->`: a field is `r.speed`, and what a robot senses is a signal \
         function, `frontSonar i`"
  | (OPERATOR _ | MINUS | STAR | SLASH | CARET), Some ({ token = LOWER _; _ } as field)
    when opens_with Layout.Brace found.context && field_of_a_value found field ->
      let name = written found field in
      Some
        (Printf.sprintf "a field gets its value with `=`, also from its own: `r { %s = r.%s + 1 }`"
           name name)
  | OPERATOR "!", _ when first_word found = "data" ->
      Some "a field always has its value: leave out the `!`"
  | BAR, before when encloses found && expects_more before ->
      Some "the absolute value of `x` is `abs x`"
  | (PARAM | DATA | TYPE | IMPORT | CLASS | INSTANCE | UNIT | FOREIGN), before
    when between found found.token.start.pos_bol found.token.start.pos_cnum = ""
         && (is_local (innermost_block found.context) || opens_block before) ->
      Some
        (Printf.sprintf "a `%s` stands at the left edge, among the program's definitions"
           (written found found.token))
  | STAR, Some _ when first_word found = "foreign" ->
      Some "C is given the address of an array or a record anyway: leave out the `*`"
  | (STAR | SLASH | MINUS | OPERATOR ("+" | "-")), Some _ when is_in_a_size found ->
      Some
        "sizes are not computed: a name of its own, as `m` in `Array m Float`, is any size, and \
         `type Twice = 16` names one"
  | BAR, Some { token = EQUAL; _ } -> Some no_equation_before_guards
  | UPPER _, Some { token = LBRACE | COMMA; _ } when opens_with Layout.Brace found.context ->
      Some
        (Printf.sprintf "the name of a field starts with a small letter: `%s`"
           (String.uncapitalize_ascii (written found found.token)))
  | ARROW, _ when lacks_of found <> None -> lacks_of found
  | WHERE, None -> Some "indent `where` and what follows it: they belong to the definition above"
  | OPERATOR "!", Some { token = OPERATOR "!"; _ } -> None
  | OPERATOR "!", _ -> Some "the opposite of `b` is `not b`"
  | OPERATOR ".", _ when is_digit (after found) ->
      Some "a number starts with a digit: `0` before the point"
  | _, Some { token = OPERATOR "."; start; _ } when is_digit (char_at found (start.pos_cnum - 1)) ->
      Some "a number ends with a digit: `0` after the point"
  | SLASH, None -> Some "a comment starts with `--`"
  | BAR, _ when is_symbol (after found) && after found <> '>' -> Some own_operator
  | BAR, _ when after found = '>' -> Some "a function stands before its argument: `f x`"
  | ( (UNIT | PRIMITIVE | FOREIGN | PARAM | CLASS | INSTANCE | DATA | TYPE | MODULE | IMPORT | REC),
      Some _ ) ->
      Some (reserved_word (written found found.token))
  | (END | SEMICOLON), before
    when expects_more before && (not found.token.last)
         && (found.token.token = END || found.token.made) ->
      Some "a definition goes on only in lines that are indented more than its first"
  | _ -> misplaced_line found

(* Where neither token nor state says more. *)
let usual found =
  match found.token.token with
  | ARROW -> (
      match found.context with
      | ((Block (Top | Let | Where) | Paren), _) :: _ ->
          Some "a function without a name is written `\\x -> …`, a signal function `proc x -> …`"
      | _ -> None)
  | LBRACE when opens_fields found "=" ->
      Some "a record is built by the name of its constructor, as in `Pose { heading = 0 }`"
  | LBRACE when opens_fields found "::" && first_word found = "type" ->
      Some "`data` declares a record, and its constructor: `data Pose = Pose { heading :: Angle }`"
  | LBRACE -> Some by_indentation
  | DOUBLE_COLON -> Some "the type of an expression stands with it in parentheses: `(e :: T)`"
  | _ -> None

let hint found ~state_hints =
  match (of_token found, state_hints, usual found) with
  | Some hint, _, _ -> [ hint ]
  | None, (_ :: _ as hints), _ -> hints
  | None, [], Some hint -> [ hint ]
  | None, [], None -> []

(* The operator that the found token is a part of, where other languages have it. *)
let foreign_operator_around found =
  let is_foreign =
    match (found.token.token, found.before) with
    | BAR, _ | SLASH, None -> is_symbol (after found)
    | EQUAL, Some before -> is_adjacent found before && assigns found <> None
    | _, Some before -> foreign_operator found before <> None
    | _, None -> false
  in
  let rec first i = if is_symbol (char_at found (i - 1)) then first (i - 1) else i in
  let rec last i = if is_symbol (char_at found i) then last (i + 1) else i in
  if is_foreign then Some (first found.token.start.pos_cnum, last found.token.stop.pos_cnum)
  else None

(* The `elif` before this `then`. *)
let else_if found =
  let stop = found.token.start.pos_cnum in
  let rec words i =
    if i < found.token.start.pos_bol then None
    else
      let ((_, last) as word) = word_from found i in
      if List.mem (part found word) [ "elif"; "elsif"; "elseif" ] && last < stop then Some word
      else words (i - 1)
  in
  match found.token.token with
  | THEN when opens_with Layout.Then found.context -> words stop
  | _ -> None

let foreign found =
  let at (line : Lexing.position) ((first, last) as it) =
    let there offset = { line with pos_cnum = offset } in
    (part found it, Build.span (there first, there last))
  in
  let here = found.token.start in
  match (beginning found, foreign_operator_around found) with
  | Some (line, _), _ -> Some (at line (first_word_from found line.pos_bol))
  | None, Some it -> Some (at here it)
  | None, None -> Option.map (at here) (else_if found)

let other_place found diagnostic =
  match found.context with
  | (((If | Then | Case) as opener), { by; _ }) :: _
    when by.start.pos_lnum <> found.token.start.pos_lnum ->
      let word = match opener with Case -> "case" | _ -> "if" in
      Diagnostic.label
        ~at:(Build.span (by.start, by.stop))
        (Printf.sprintf "this `%s`" word) diagnostic
  | _ -> diagnostic
