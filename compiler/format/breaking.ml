open Syntax.Grammar

let most = 100

(* {1 Operators} *)

(* The cost of a break at an operator. A line is broken where the cost is lowest, so loosely binding
   operators cost less. Breaks inside numbers and names cost [tight], which forbids them. *)
let tight = 1000

let cost_of_operator = function
  | "$" -> 20
  | ">>>" | "<<<" -> 21
  | "||" -> 22
  | "&&" | "***" | "&&&" -> 23
  | "==" | "/=" | "<" | "<=" | ">" | ">=" -> 26
  | ".|." -> 27
  | "+" | "-" | "^+^" | "^-^" -> 28
  | "*" | "/" | "*^" | ".&." -> 29
  | _ -> tight

let operator (words : Word.t array) k =
  match words.(k).token.token with
  | OPERATOR text -> Some (cost_of_operator text)
  | STAR -> Some (cost_of_operator "*")
  | SLASH -> Some (cost_of_operator "/")
  | CARET -> Some tight
  | MINUS -> if words.(k).prefix then None else Some (cost_of_operator "-")
  | BACKTICK when not words.(k).in_quotes -> Some 25
  | TAIL -> Some 18
  | _ -> None

let ends_operand (token : Syntax.Grammar.token) =
  match token with
  | LOWER _ | UPPER _ | QUALIFIED_LOWER _ | QUALIFIED_UPPER _ | FIELD _ | NUMBER _ | STRING _
  | RPAREN | RBRACKET | RBRACE | UNDERSCORE ->
      true
  | _ -> false

let starts_operand (token : Syntax.Grammar.token) =
  match token with
  | LOWER _ | UPPER _ | QUALIFIED_LOWER _ | QUALIFIED_UPPER _ | NUMBER _ | STRING _ | LPAREN
  | LBRACKET | UNDERSCORE | BACKSLASH | PROC | LAMBDA_CASE | DO ->
      true
  | _ -> false

(* {1 Structure of a line} *)

(* Minimum width of the part after a break. A shorter part is not worth a separate line. *)
let least_rest = 12
let is_opener = function LPAREN | LBRACKET | LBRACE -> true | _ -> false
let is_closer = function RPAREN | RBRACKET | RBRACE -> true | _ -> false

(* Whether the word opens the brackets around a function that is the last argument. The line is then
   broken inside the function, not before it. *)
let hugs (words : Word.t array) ~last k =
  words.(k).token.token = LPAREN && k < last
  && words.(k - 1).token.token <> RPAREN
  && (match words.(k + 1).token.token with
     | PROC | BACKSLASH | LAMBDA_CASE | DO | CASE -> true
     | _ -> false)
  &&
  let rec only_ends i =
    i > last
    || (match words.(i).token.token with RPAREN | WHERE -> true | _ -> false)
       && only_ends (i + 1)
  in
  words.(k).partner > last || only_ends words.(k).partner

(* Whether the word opens a list or tuple that has almost nothing after it on the line. *)
let spans (words : Word.t array) ~last k =
  let w = words.(k) in
  is_opener w.token.token && w.partner > k && w.partner <= last
  && (let inside = words.(k + 1).frame in
      let rec some i =
        i < w.partner
        && ((words.(i).token.token = COMMA && words.(i).frame = inside) || some (i + 1))
      in
      some (k + 1))
  &&
  let rec little k width =
    width <= least_rest && (k > last || little (k + 1) (width + words.(k).gap + words.(k).width))
  in
  little (w.partner + 1) 0

(* A part of the line: its depth, and whether it contains operators. *)
type part = { depth : int; mutable operators : bool }

let depth_cost = 50

(* For each word up to [until], computes the part of the line that contains it. The text between
   brackets, and after [if], [do] and similar keywords, is nested more deeply. *)
let parts (words : Word.t array) ~first ~until ~last =
  let whole = { depth = 0; operators = false } in
  let found = Array.make (until - first + 1) whole in
  let stack = ref [] in
  let here () = match !stack with (_, part) :: _ -> part | [] -> whole in
  let rec to_bracket () =
    match !stack with
    | ((`Open | `Let), _) :: rest ->
        stack := rest;
        to_bracket ()
    | _ -> ()
  in
  let rec to_let () =
    match !stack with
    | (`Open, _) :: rest ->
        stack := rest;
        to_let ()
    | (`Let, _) :: rest -> stack := rest
    | _ -> ()
  in
  let push kind more =
    stack := (kind, { depth = (here ()).depth + more; operators = false }) :: !stack
  in
  for k = first to until do
    let token = words.(k).token.token in
    if is_closer token then (
      to_bracket ();
      match !stack with (`Bracket, _) :: rest -> stack := rest | _ -> ());
    if token = COMMA then to_bracket ();
    if token = IN then to_let ();
    let part = here () in
    found.(k - first) <- part;
    if operator words k <> None then part.operators <- true;
    match token with
    | LPAREN | LBRACKET | UNIT_BRACKET | LBRACE ->
        push `Bracket (if hugs words ~last k then 0 else 1)
    | LET -> push `Let 2
    | IF | CASE -> push `Open 1
    | DO | OF | LAMBDA_CASE | REC -> push `Open 2
    | ARROW when not words.(k).in_type -> push `Open 0
    | EQUAL | LEFT_ARROW -> push `Open 0
    | _ -> ()
  done;
  found

(* {1 Where to break} *)

(* The cost of a break before a word; [None] if the line cannot be broken there. *)
let cost (words : Word.t array) ~first ~last (part : part) k =
  let w = words.(k) and before = words.(k - 1) in
  let kind =
    if (w.in_unit && before.in_unit) || w.in_quotes || before.prefix || w.comments <> [] then None
    else
      match (before.token.token, w.token.token) with
      | _, (COMMA | SEMICOLON | UNIT_BRACKET | FIELD _ | AT | RPAREN | RBRACKET | RBRACE) -> None
      | _, (WHERE | EQUAL | LEFT_ARROW | OF) -> None
      | (BACKSLASH | AT | SEMICOLON), _ -> None
      | (DO | OF | WHERE | LET | LAMBDA_CASE), _ -> Some 1
      | _, (ARROW | DOUBLE_ARROW) when w.in_type -> Some 10
      | _, BAR -> Some 5
      | _, THEN | _, ELSE -> Some 16
      | _, IN -> Some 20
      | ARROW, _ when not before.in_type -> Some 15
      | (EQUAL | LEFT_ARROW), (IF | CASE | LET) -> Some 12
      | (EQUAL | LEFT_ARROW), (LBRACKET | LPAREN) when spans words ~last k -> Some 12
      | (EQUAL | LEFT_ARROW), DO -> None
      | (EQUAL | LEFT_ARROW), _ -> Some 30
      | COMMA, _ -> Some (if part.depth = 0 && words.(first).item then 40 else 14)
      | _, DOUBLE_COLON ->
          let of_names = k >= 2 && words.(k - 2).token.token = COMMA in
          Some (if part.depth > 0 then 14 else if of_names then 12 else 35)
      | _, LBRACE -> Some (if part.operators then 45 else 24)
      | a, b when ends_operand a && starts_operand b ->
          if hugs words ~last k then None
          else
            let is_group = match b with LPAREN | LBRACKET -> true | _ -> false in
            Some ((if part.operators then 40 else 26) + if is_group then 0 else 3)
      | _ -> ( match operator words k with Some cost when cost < tight -> Some cost | _ -> None)
  in
  Option.map (fun cost -> cost + (depth_cost * part.depth)) kind

let of_a_short_rest = 20
let of_a_long_rest = 25
let least_gain = 4

(* The word with the cheapest break before it, among the words up to [until]. [columns] contains the
   columns of these words. *)
let best words ~first ~until ~last ~outer ~inner ~stop (columns : int array) =
  let parts = parts words ~first ~until ~last in
  let better k best =
    let part = parts.(k - first) in
    let left = columns.(k - 1 - first) + words.(k - 1).Word.width in
    let at = if part.depth = 0 then outer else inner in
    let rest = stop - columns.(k - first) in
    let gain = columns.(k - first) - at in
    let is_list =
      match (words.(k - 1).token.token, words.(k).token.token) with
      | EQUAL, (LPAREN | LBRACKET) -> spans words ~last k
      | _ -> false
    in
    if gain < least_gain && (gain < 0 || not is_list) && (gain <= 0 || at + rest > most) then best
    else
      match cost words ~first ~last part k with
      | None -> best
      | Some cost -> (
          let cost =
            cost
            + (if left > most then 10_000 + left else 0)
            + (if rest < least_rest then of_a_short_rest else 0)
            + if at + rest > most then of_a_long_rest else 0
          in
          match best with Some (least, _) when least < cost -> best | _ -> Some (cost, k))
  in
  let rec go k found = if k > until then found else go (k + 1) (better k found) in
  go (first + 1) None

(* {1 Lists} *)

(* Breaks a list that starts a line: each line takes as many elements as fit, continuation lines
   start with a comma, and the closing bracket is on its own line. *)
let list (words : Word.t array) ~first ~column =
  let opener = words.(first) and close = words.(first).partner in
  let inside = words.(first + 1).frame in
  let is_comma k = words.(k).token.token = COMMA && words.(k).frame = inside in
  opener.commas_first <- true;
  words.(close).commas_first <- true;
  words.(close).starts <- true;
  words.(first + 1).gap <- 1;
  let rec element k width =
    if k >= close || is_comma k then (k, width)
    else element (k + 1) (width + words.(k).gap + words.(k).width)
  in
  let rec fill k at =
    if k < close then
      (* the width of an element includes 1 column for its comma *)
      let next, width = element (k + 1) 1 in
      if at + width > most then (
        words.(k).starts <- true;
        fill next (column + width))
      else fill next (at + width)
  in
  let next, width = element (first + 1) 1 in
  fill next (column + width)

(* Examines only a window of the line at a time, and enlarges it until a break is found. Generated
   programs may consist of one very long line. *)
let rec within (words : Word.t array) ~first ~last ~column ~outer ~inner window =
  let columns = Array.make (min (last - first) window + 1) column in
  let until = first + Array.length columns - 1 in
  let last = ref last in
  (try
     for k = first + 1 to until do
       if words.(k).starts then (
         last := k - 1;
         raise Exit);
       columns.(k - first) <- columns.(k - 1 - first) + words.(k - 1).width + words.(k).gap
     done
   with Exit -> ());
  let last = !last in
  let until = min until last in
  let stop = columns.(until - first) + words.(until).width in
  if stop > most then
    if spans words ~last first then list words ~first ~column
    else
      match best words ~first ~until ~last ~outer ~inner ~stop columns with
      | Some (cost, k) when until = last || cost < 10_000 -> words.(k).starts <- true
      | _ when until < last -> within words ~first ~last ~column ~outer ~inner (8 * window)
      | Some (_, k) -> words.(k).starts <- true
      | None -> ()

let line words ~first ~last ~column ~outer ~inner =
  within words ~first ~last ~column ~outer ~inner 200
