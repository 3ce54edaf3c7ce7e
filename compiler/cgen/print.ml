open Ir

(* Operator precedence as in the C standard, 6.5. Higher numbers bind tighter. *)
let postfix = 15
let prefix = 14
let conditional = 3

let level = function
  | Times | Over | Remainder -> 13
  | Plus | Minus -> 12
  | Less | Less_equal | Greater -> 10
  | Equal | Not_equal -> 9
  | And -> 5
  | Or -> 4

let symbol = function
  | Times -> "*"
  | Over -> "/"
  | Remainder -> "%"
  | Plus -> "+"
  | Minus -> "-"
  | Less -> "<"
  | Less_equal -> "<="
  | Greater -> ">"
  | Equal -> "=="
  | Not_equal -> "!="
  | And -> "&&"
  | Or -> "||"

(* The levels of operands that need no parentheses, on the left and on the right. C would accept [a
   < b == c] and [a && b || c], but these confuse readers and cause warnings with -Wparentheses. *)
let operand_levels operator =
  match operator with
  | Times | Over | Remainder | Plus | Minus -> (level operator, level operator + 1)
  | Less | Less_equal | Greater | Equal | Not_equal -> (11, 11)
  | And | Or -> (level operator, level operator)

(* Writes [1e+09] as [1e9]. *)
let tidy_exponent text =
  match String.index_opt text 'e' with
  | None -> text
  | Some k ->
      let mantissa = String.sub text 0 k in
      let exponent = String.sub text (k + 1) (String.length text - k - 1) in
      let exponent = String.concat "" (String.split_on_char '+' exponent) in
      Printf.sprintf "%se%d" mantissa (int_of_string exponent)

let real_name : Basis.Real.t -> string = function Double -> "double" | Single -> "float"
let real_suffix : Basis.Real.t -> string = function Double -> "" | Single -> "f"

let float_literal real x =
  let named name = Printf.sprintf "(%s)%s" (real_name real) name in
  let decimal () =
    if Float.is_integer x && Float.abs x < 1e7 then
      (if Float.sign_bit x then "-" else "") ^ string_of_int (abs (int_of_float x)) ^ ".0"
    else
      let text = tidy_exponent (Basis.Real.shortest real x) in
      if String.exists (function '.' | 'e' -> true | _ -> false) text then text else text ^ ".0"
  in
  if Float.is_nan x then named "NAN"
  else if Float.equal x Float.infinity then named "INFINITY"
  else if Float.equal x Float.neg_infinity then "-" ^ named "INFINITY"
  else decimal () ^ real_suffix real

let rec ty_name = function
  | Array (t, _) -> ty_name t
  | Void -> "void"
  | Bool -> "bool"
  | Uint8 -> "uint8_t"
  | Uint32 -> "uint32_t"
  | Int32 -> "int32_t"
  | Int64 -> "int64_t"
  | Real real -> real_name real
  | Struct name -> "struct " ^ name
  | Named name -> name
  | Members _ -> "struct"
  | Union _ -> "union"
  | Pointer ((Pointer _ | Pointer_to_const _) as t) -> ty_name t ^ "*"
  | Pointer t -> ty_name t ^ " *"
  | Pointer_to_const t -> "const " ^ ty_name t ^ " *"

let rec declarator ty name =
  match ty with
  | Array (t, n) -> declarator t (Printf.sprintf "%s[%d]" name n)
  | Pointer _ | Pointer_to_const _ -> ty_name ty ^ name
  | Void | Bool | Uint8 | Uint32 | Int32 | Int64 | Real _ | Struct _ | Named _ | Members _ | Union _
    ->
      ty_name ty ^ " " ^ name

(* [const T x], or [T *const x] for pointers. *)
let constant ty name =
  match ty with
  | Pointer _ | Pointer_to_const _ -> ty_name ty ^ "const " ^ name
  | _ -> "const " ^ declarator ty name

(* Declares several variables of one type. Each pointer needs its own star. *)
let variables ty names =
  let separator = match ty with Pointer _ | Pointer_to_const _ -> ",\001*" | _ -> ",\001" in
  declarator ty (String.concat separator names)

let precedence = function
  | Name _ | Boolean _ | Long _ | Call _ | Member _ | Arrow _ | Subscript _ | Aggregate _ -> postfix
  | Integer i -> if Int32.compare i 0l < 0 then prefix else postfix
  | Float (_, x) ->
      if Float.sign_bit x || not (Float.abs x < Float.infinity) then prefix else postfix
  | Unary _ | Cast _ -> prefix
  | Binary (operator, _, _) -> level operator
  | Conditional _ -> conditional

(* A control character represents a space at which a long line may be broken. The smaller the
   character, the closer it is to the root of the expression. The smallest one follows the [=] of an
   assignment. *)
let deepest = 31
let after_equals = "\000"
let is_soft c = Char.code c <= deepest
let soft b ~depth = Buffer.add_char b (Char.chr (min depth deepest))

let rec expr b ~depth ~at e =
  let parenthesized = precedence e < at in
  if parenthesized then Buffer.add_char b '(';
  bare b ~depth e;
  if parenthesized then Buffer.add_char b ')'

and bare b ~depth e =
  let add = Buffer.add_string b in
  match e with
  | Name name -> add name
  | Boolean value -> add (string_of_bool value)
  | Integer i -> if Int32.equal i Int32.min_int then add "INT32_MIN" else add (Int32.to_string i)
  | Long i -> add (Printf.sprintf "INT64_C(%Ld)" i)
  | Float (real, x) -> add (float_literal real x)
  | Unary (operator, e) ->
      add (match operator with Negate -> "-" | Not -> "!" | Address -> "&" | Dereference -> "*");
      (* Avoids two adjacent minus signs. *)
      let at =
        match (operator, e) with
        | Negate, (Unary (Negate, _) | Float _ | Integer _) -> postfix
        | _ -> prefix
      in
      expr b ~depth ~at e
  | Cast (ty, e) ->
      add "(";
      add (ty_name ty);
      add ")";
      expr b ~depth ~at:prefix e
  | Binary (operator, left, right) ->
      let at_left, at_right = operand_levels operator in
      (* A chain such as a + b - c breaks before all of its operators or none. *)
      let is_chain = match left with Binary (o, _, _) -> level o = level operator | _ -> false in
      logical b ~depth:(if is_chain then depth else depth + 1) operator ~at:at_left left;
      soft b ~depth;
      add (symbol operator);
      add " ";
      logical b ~depth:(depth + 1) operator ~at:at_right right
  | Conditional (_, _, Conditional _) -> choices b ~depth e
  | Conditional (c, x, y) ->
      expr b ~depth:(depth + 1) ~at:(conditional + 1) c;
      soft b ~depth;
      add "? ";
      expr b ~depth:(depth + 1) ~at:(conditional + 1) x;
      soft b ~depth;
      add ": ";
      expr b ~depth:(depth + 1) ~at:conditional y
  | Call (name, arguments) ->
      add name;
      add "(";
      separated b ~depth arguments;
      add ")"
  | Member (e, name) ->
      expr b ~depth ~at:postfix e;
      add ".";
      add name
  | Subscript (e, index) ->
      expr b ~depth ~at:postfix e;
      add "[";
      expr b ~depth:(depth + 1) ~at:0 index;
      add "]"
  | Aggregate values ->
      add "{";
      separated b ~depth values;
      add "}"
  | Arrow (e, name) ->
      expr b ~depth ~at:postfix e;
      add "->";
      add name

(* A chain of conditional expressions has one line for each condition with its value. *)
and choices b ~depth e =
  match e with
  | Conditional (c, x, y) ->
      expr b ~depth:(depth + 2) ~at:(conditional + 1) c;
      soft b ~depth:(depth + 1);
      Buffer.add_string b "? ";
      expr b ~depth:(depth + 2) ~at:(conditional + 1) x;
      soft b ~depth;
      Buffer.add_string b ": ";
      choices b ~depth y
  | e -> expr b ~depth:(depth + 1) ~at:conditional e

and separated b ~depth values =
  List.iteri
    (fun k e ->
      if k > 0 then (
        Buffer.add_char b ',';
        soft b ~depth);
      expr b ~depth:(depth + 1) ~at:0 e)
    values

(* Adds parentheses around [a && b] inside [||], as compilers recommend. *)
and logical b ~depth operator ~at e =
  match (operator, e) with
  | Or, Binary (And, _, _) -> expr b ~depth ~at:postfix e
  | _, _ -> expr b ~depth ~at e

let with_breaks ?(depth = 1) e =
  let b = Buffer.create 64 in
  expr b ~depth ~at:0 e;
  Buffer.contents b

let add_flat out text =
  Buffer.add_string out (String.map (fun c -> if is_soft c then ' ' else c) text)

(* Lines *)

let width = 96
let comment_column = 60

let outermost text =
  String.fold_left (fun least c -> if is_soft c then min least c else least) '\255' text

(* Splits the text at the soft spaces closest to the root. *)
let pieces text = String.split_on_char (outermost text) text
let fits column text = column + String.length text <= width
let is_comma piece = String.ends_with ~suffix:"," piece
let is_choice piece = String.starts_with ~prefix:": " piece

(* Writes text that is too long for one line, and returns the column where it ends. Fills each line
   with pieces that end with commas, or with operators of one level and their operands. But if one
   of these operands needs more than one line, each operator of the level starts a new line.
   Otherwise, the operator would be harder to see than the tighter-binding operators at which the
   operand is broken. Both branches of a conditional expression also start new lines. *)
let rec fill out ~indent ~column text =
  if fits column text || not (String.exists is_soft text) then (
    add_flat out text;
    column + String.length text)
  else
    match pieces text with
    | [] -> column
    | [ target; value ] when outermost text = after_equals.[0] ->
        assigned out ~indent ~column:(fill out ~indent ~column target) value
    | first :: rest when is_comma first ->
        let column = fill out ~indent ~column first in
        List.fold_left (fun column piece -> next out ~indent ~column piece) column rest
    | first :: rest ->
        let is_broken = List.exists is_choice rest || not (List.for_all (fits indent) rest) in
        let operand (column, is_broken) piece =
          if is_broken then (new_line out ~indent piece, true)
          else (next out ~indent ~column piece, false)
        in
        let is_broken = is_broken || not (fits column first) in
        let column = fill out ~indent:(indent + 4) ~column first in
        fst (List.fold_left operand (column, is_broken) rest)

and next out ~indent ~column piece =
  if fits (column + 1) piece then (
    Buffer.add_char out ' ';
    add_flat out piece;
    column + 1 + String.length piece)
  else new_line out ~indent piece

and new_line out ~indent piece =
  Buffer.add_string out ("\n" ^ String.make indent ' ');
  fill out ~indent:(indent + 4) ~column:indent piece

(* The value starts a new line if its first operand does not fit after the [=]. *)
and assigned out ~indent ~column value =
  let first = List.hd (pieces value) in
  let is_call = (not (String.exists is_soft value)) || is_comma first in
  if is_call || fits (column + 1) first then (
    Buffer.add_char out ' ';
    fill out ~indent ~column:(column + 1) value)
  else new_line out ~indent value

let line out ~indent ?(column = comment_column) ?(comment = "") text =
  Buffer.add_string out (String.make indent ' ');
  if indent + String.length text <= width then (
    add_flat out text;
    if comment <> "" then (
      let spaces = max 1 (column - indent - String.length text) in
      Buffer.add_string out (String.make spaces ' ');
      Buffer.add_string out ("/* " ^ comment ^ " */")))
  else (
    ignore (fill out ~indent:(indent + 8) ~column:indent text);
    if comment <> "" then Buffer.add_string out (" /* " ^ comment ^ " */"));
  Buffer.add_char out '\n'

let commas values = String.concat ",\001" values

let rec continues = function
  | [] -> false
  | [ { desc = Continue; _ } ] -> true
  | _ :: rest -> continues rest

let rec statement out ~indent { desc; comment } =
  let put text = line out ~indent ~comment text in
  let assign target operator value =
    put (String.concat "" [ target; " "; operator; after_equals; with_breaks value; ";" ])
  in
  match desc with
  | Constant { ty; name; value } -> assign (constant ty name) "=" value
  | Table { ty; name; value } -> assign ("static const " ^ declarator ty name) "=" value
  | Variables { ty; names } -> put (variables ty names ^ ";")
  | Variable { ty; name; value } -> assign (declarator ty name) "=" value
  | Initialize { ty; name; values } ->
      put (declarator ty name ^ " = {" ^ commas (List.map (with_breaks ~depth:2) values) ^ "};")
  | Assign (place, value) -> assign (with_breaks place) "=" value
  | Add_to (place, value) -> assign (with_breaks place) "+=" value
  | Do e -> put (with_breaks e ^ ";")
  | Return e -> put ("return " ^ with_breaks e ^ ";")
  | If { condition; then_; else_ } ->
      put ("if (" ^ with_breaks condition ^ ") {");
      branches out ~indent then_ else_
  | For { index; count; body } ->
      put (Printf.sprintf "for (int32_t %s = 0; %s < %d; %s++) {" index index count index);
      List.iter (statement out ~indent:(indent + 4)) body;
      line out ~indent "}"
  | Repeat { rounds; most; body } ->
      put "do {";
      List.iter (statement out ~indent:(indent + 4)) body;
      line out ~indent (Printf.sprintf "} while (++%s < %d);" rounds most)
  | Continue -> put "continue;"
  | Break -> put "break;"
  | Switch { value; cases } ->
      put ("switch (" ^ with_breaks value ^ ") {");
      let last = List.length cases - 1 in
      List.iteri
        (fun k (constant, body) ->
          if k = last then line out ~indent ~comment:constant "default: {"
          else line out ~indent ("case " ^ constant ^ ": {");
          List.iter (statement out ~indent:(indent + 4)) body;
          if not (continues body) then line out ~indent:(indent + 4) "break;";
          line out ~indent "}")
        cases;
      line out ~indent "}"

and branches out ~indent then_ else_ =
  List.iter (statement out ~indent:(indent + 4)) then_;
  match else_ with
  | [] -> line out ~indent "}"
  | [ { desc = If { condition; then_; else_ }; comment } ] ->
      line out ~indent ~comment ("} else if (" ^ with_breaks condition ^ ") {");
      branches out ~indent then_ else_
  | else_ ->
      line out ~indent "} else {";
      List.iter (statement out ~indent:(indent + 4)) else_;
      line out ~indent "}"

(* Declarations *)

let rec innermost : ty -> ty = function Array (t, _) -> innermost t | t -> t

let rec members out ~indent (all : member list) =
  let text { name; ty; comment = _ } =
    let rec closing name : ty -> string option = function
      | Members _ | Union _ -> Some ("} " ^ name ^ ";")
      | Array (t, n) -> closing (Printf.sprintf "%s[%d]" name n) t
      | _ -> None
    in
    Option.value (closing name ty) ~default:(declarator ty name ^ ";")
  in
  let widest = List.fold_left (fun width m -> max width (String.length (text m))) 0 all in
  let column = min comment_column (indent + widest + 1) in
  List.iter
    (fun m ->
      (match innermost m.ty with
      | Members inside ->
          line out ~indent "struct {";
          members out ~indent:(indent + 4) inside
      | Union inside ->
          line out ~indent "union {";
          members out ~indent:(indent + 4) inside
      | _ -> ());
      line out ~indent ~column ~comment:m.comment (text m))
    all

let heading out comment = if comment <> "" then line out ~indent:0 ("/* " ^ comment ^ " */")

let signature { linkage; result; name; parameters; _ } =
  let linkage =
    match linkage with External -> "" | Static -> "static " | Static_inline -> "static inline "
  in
  let parameters =
    match parameters with
    | [] -> [ "void" ]
    | parameters -> List.map (fun (ty, name) -> declarator ty name) parameters
  in
  String.concat "" [ linkage; declarator result name; "("; commas parameters; ")" ]

let declaration out = function
  | Text text -> Buffer.add_string out text
  | Struct_definition { name; overlaid; members = fields; comment } ->
      heading out comment;
      line out ~indent:0 ((if overlaid then "struct FROB_OVERLAID " else "struct ") ^ name ^ " {");
      members out ~indent:4 fields;
      line out ~indent:0 "};"
  | Constants { names; comment } ->
      heading out comment;
      line out ~indent:0 "enum {";
      let last = List.length names - 1 in
      List.iteri
        (fun k name ->
          let comma = if k = last then "" else "," in
          line out ~indent:4 (name ^ comma))
        names;
      line out ~indent:0 "};"
  | Prototype function_ ->
      heading out function_.comment;
      line out ~indent:0 (signature function_ ^ ";")
  | Function function_ ->
      heading out function_.comment;
      line out ~indent:0 (signature function_);
      line out ~indent:0 "{";
      List.iter (statement out ~indent:4) function_.body;
      line out ~indent:0 "}"

let file declarations =
  (* Prints each declaration separately, because a buffer for a large program would be copied
     repeatedly while it grows. *)
  let out = Buffer.create 4096 in
  let text d =
    Buffer.clear out;
    declaration out d;
    Buffer.contents out
  in
  String.concat "\n" (Basis.Long_list.map text declarations)
