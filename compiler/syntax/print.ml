open Ir
open Print_type

(* All printers write to [b]. [column] is the indentation of the current line, from 0. A block
   opened on that line is indented to [column + 2]. A [where] is indented to [column + 1], so that it
   closes all blocks that the line has opened. *)

let line b column =
  Buffer.add_char b '\n';
  text b (String.make column ' ')

let on_lines b column print parts =
  List.iter
    (fun part ->
      line b column;
      print b column part)
    parts

(* {1 Patterns} *)

let number b (n : number) =
  text b n.digits;
  Option.iter (fun u -> in_brackets b [ u ]) n.unit_

let rec pattern b (p : pattern) =
  match p.desc with
  | Constructed (c, ps) ->
      qualified b c;
      words b argument_pattern ps
  | Literal { negative = true; number = n } ->
      text b "-";
      number b n
  | Any | Bound _ | As _ | Tuple_of _ | Array_of _ | Record_of _ | Literal { negative = false; _ }
    ->
      argument_pattern b p

and argument_pattern b p =
  match p.desc with
  | As (x, p) ->
      text b (x.text ^ "@");
      primary_pattern b p
  | Any | Bound _ | Tuple_of _ | Array_of _ | Record_of _ | Constructed _ | Literal _ ->
      primary_pattern b p

and primary_pattern b p =
  match p.desc with
  | Any -> text b "_"
  | Bound x -> text b x.text
  | Tuple_of ps -> enclosed b "(" ")" (pattern b) ps
  | Array_of ps -> enclosed b "[" "]" (pattern b) ps
  | Constructed (c, []) -> qualified b c
  | Record_of (c, fields) ->
      qualified b c;
      let field ((x : name), p) =
        text b (x.text ^ " = ");
        pattern b p
      in
      enclosed b " { " " }" field fields
  | Literal { negative = false; number = n } -> number b n
  | Constructed _ | Literal { negative = true; _ } | As _ ->
      between b "(" ")" (fun () -> pattern b p)

(* {1 Expressions} *)

let string_literal s =
  let b = Buffer.create 16 in
  String.iter
    (function
      | '"' -> text b "\\\""
      | '\\' -> text b "\\\\"
      | '\n' -> text b "\\n"
      | '\t' -> text b "\\t"
      | c -> Buffer.add_char b c)
    s;
  "\"" ^ Buffer.contents b ^ "\""

(* Can the expression be an argument without parentheses? *)
let is_argument (e : expr) =
  match e.desc with
  | Variable _ | Constructor _ | Number _ | String _ | Tuple _ | Tuple_section _ | Array _
  | Left_section _ | Right_section _ | Record _ | Update _ | Field _ | Annotated _ | Parenthesized _
    ->
      true
  | Apply _ | Binary _ | Negate _ | Power _ | If _ | Case _ | Let _ | Lambda _ | Lambda_case _
  | Proc _ | Sequence _ ->
      false

let rec is_application (e : expr) =
  match e.desc with Apply (f, x) -> is_argument x && is_application f | _ -> is_argument e

let rec expr b column (e : expr) =
  let expr = expr b column in
  match e.desc with
  | Variable x | Constructor x -> qualified b x
  | Number n -> number b n
  | String s -> text b (string_literal s)
  | Tuple es -> enclosed b "(" ")" expr es
  | Tuple_section places -> enclosed b "(" ")" (Option.iter expr) places
  | Array es -> enclosed b "[" "]" expr es
  | Apply (f, x) ->
      expr f;
      text b (if is_argument x && is_application f then " " else " $ ");
      expr x
  | Binary { operator; left; right } ->
      expr left;
      between b " " " " (fun () -> infix b operator);
      expr right
  | Negate e ->
      text b "-";
      expr e
  | Left_section { left; operator } ->
      between b "(" ")" (fun () ->
          expr left;
          text b " ";
          infix b operator)
  | Right_section { operator; right } ->
      between b "(" ")" (fun () ->
          infix b operator;
          text b " ";
          expr right)
  | Power { base; exponent } ->
      expr base;
      text b
        (if exponent < 0 then Printf.sprintf " ^ (%d)" exponent else Printf.sprintf " ^ %d" exponent)
  | If { condition; then_; else_ } ->
      between b "if " " then " (fun () -> expr condition);
      expr then_;
      text b " else ";
      expr else_
  | Case { scrutinee; branches } ->
      between b "case " " of" (fun () -> expr scrutinee);
      block_of b column branches
  | Lambda_case branches ->
      text b "\\case";
      block_of b column branches
  | Let { bindings; body } ->
      text b "let";
      block b column bindings;
      line b (column + 1);
      text b "in ";
      expr body
  | Lambda { parameters; body } ->
      between b "\\" " -> " (fun () -> separated b " " (argument_pattern b) parameters);
      expr body
  | Proc { input; body } ->
      between b "proc " " -> " (fun () -> argument_pattern b input);
      proc_body b column body
  | Sequence { statements; result } -> sequence b (column + 2) statements result
  | Record { constructor; fields = fs } ->
      qualified b constructor;
      fields b column fs
  | Update { record; fields = fs } ->
      expr record;
      fields b column fs
  | Field { record; field } ->
      expr record;
      text b ("." ^ field.text)
  | Annotated { expr = e; ty } ->
      between b "(" ")" (fun () ->
          expr e;
          text b " :: ";
          qualified_type b ty)
  | Parenthesized e -> between b "(" ")" (fun () -> expr e)

and sequence b column statements result =
  text b "do";
  on_lines b column task_statement statements;
  line b column;
  expr b column result

and fields b column list =
  let field ((x : name), e) =
    text b (x.text ^ " = ");
    expr b column e
  in
  enclosed b " { " " }" field list

and proc_body b column = function
  | Output { output; equations } ->
      expr b column output;
      where b column equations
  | Command c -> command b column c
  | Do { statements; result } ->
      text b "do";
      on_lines b (column + 2) statement statements;
      line b (column + 2);
      command b (column + 2) result

and command b column c =
  expr b column c.signal_function;
  text b " -< ";
  expr b column c.argument

and statement b column = function
  | Bind { pattern = p; command = c } ->
      pattern b p;
      text b " <- ";
      command b column c
  | Bind_expr { pattern = p; expr = e; _ } ->
      pattern b p;
      text b " <- ";
      expr b column e
  | Let_equations bindings ->
      text b "let";
      block b column bindings

and task_statement b column = function
  | Task { pattern = p; task; span = _ } ->
      Option.iter
        (fun p ->
          pattern b p;
          text b " <- ")
        p;
      expr b column task
  | Let_values bindings ->
      text b "let";
      block b column bindings

and block_of b column branches = on_lines b (column + 2) branch branches

and branch b column (x : branch) =
  pattern b x.pattern;
  (match x.body with
  | Always e ->
      text b " -> ";
      expr b column e
  | If_guards list -> guards b column " -> " list);
  where b column x.where

and guards b column arrow list =
  let guard b column (condition, e) =
    between b "| " arrow (fun () -> expr b column condition);
    expr b column e
  in
  on_lines b (column + 2) guard list

and where b column = function
  | [] -> ()
  | declarations ->
      line b (column + 1);
      text b "where";
      block b column declarations

and block b column declarations = on_lines b (column + 2) declaration declarations

(* {1 Declarations} *)

and binding b column (x : binding) =
  (match x.left with
  | Name x -> name b x
  | Function_name { name = x; parameters } ->
      name b x;
      words b argument_pattern parameters
  | Pattern ({ desc = Bound _; _ } as p) -> between b "(" ")" (fun () -> pattern b p)
  | Pattern p -> pattern b p);
  (match x.right.body with
  | Plain e ->
      text b " = ";
      expr b column e
  | Guarded list -> guards b column " = " list);
  where b column x.right.where

and declaration b column (d : declaration) =
  doc b column d.doc;
  match d.desc with
  | Signature s -> signature b s
  | Binding x -> binding b column x
  | Type_alias { name = x; parameters; body } ->
      text b "type ";
      head b x parameters;
      text b " = ";
      type_to b body
  | Data { name = x; parameters; constructors } ->
      text b "data ";
      head b x parameters;
      data b column constructors
  | Class { superclasses; name; variable; members } ->
      let of_variable c = (c, ({ desc = Type_variable variable; span = variable.span } : ty)) in
      text b "class ";
      context b (List.map of_variable superclasses);
      text b name.text;
      text b (" " ^ variable.text);
      where b column members
  | Instance { context = constraints; class_; head; members } ->
      text b "instance ";
      context b constraints;
      qualified b class_;
      text b " ";
      simple_type b head;
      where b column members
  | Base_unit x -> text b ("unit " ^ x.text)
  | Scaled_unit { name = x; scale; unit_ } ->
      text b ("unit " ^ x.text ^ " = ");
      scaled b scale unit_
  | Primitive s ->
      text b "primitive ";
      signature b s
  | Foreign f ->
      text b "foreign ";
      foreign b f
  | Parameter { name; ty; value } ->
      text b "param ";
      signature b { names = [ name ]; ty };
      text b " = ";
      expr b column value
  | Claim { kind; label; condition } ->
      text b (match kind with Assert -> "assert " | Assume -> "assume ");
      text b (string_literal label.text);
      text b " ";
      expr b column condition
  | Check { kind; label; value } ->
      text b (match kind with Test -> "test " | Trial -> "trial ");
      text b (string_literal label.text);
      text b " = ";
      expr b column value

and foreign b = function
  | Foreign_value { kind; name; ty; symbol } ->
      (match kind with Foreign_function -> () | Foreign_signal_function -> text b "sf ");
      signature b { names = [ name ]; ty };
      text b " = ";
      text b (string_literal symbol.text)
  | Foreign_type { name; c_type; copyable } ->
      text b ("type " ^ name.text ^ " = ");
      text b (string_literal c_type.text);
      if copyable then text b " copyable"
  | Foreign_include header ->
      text b "include ";
      text b (string_literal header.text)

and doc b column = function
  | None -> ()
  | Some lines ->
      List.iteri
        (fun i s ->
          text b (if i = 0 then "-- |" else "--");
          if s <> "" then text b (" " ^ s);
          line b column)
        (String.split_on_char '\n' lines)

and head b x parameters =
  text b x.text;
  if parameters.units <> [] then enclosed b "[" "]" (name b) parameters.units;
  words b name parameters.types

and data b column constructors =
  List.iteri
    (fun i (c : constructor) ->
      line b (column + 2);
      doc b (column + 2) c.doc;
      text b (if i = 0 then "= " else "| ");
      text b c.name.text;
      match c.fields with
      | Positional ts -> words b simple_type ts
      | Named fields ->
          let field ((x : name), t) =
            text b (x.text ^ " :: ");
            type_to b t
          in
          enclosed b " { " " }" field fields)
    constructors

(* The scale comes first. If the unit starts with [1], its other factors directly follow the
   scale. *)
and scaled b scale u =
  let written = scale.factor <> "1" || scale.times_pi || scale.divided_by <> "1" in
  if scale.factor <> "1" || not scale.times_pi then if written then text b scale.factor;
  if scale.times_pi then text b (if scale.factor = "1" then "pi" else " pi");
  if scale.divided_by <> "1" then text b ("/" ^ scale.divided_by);
  if not written then unit_to b u
  else
    let rec continued (u : unit_) =
      match u.desc with
      | One -> ()
      | Times (l, r) ->
          continued l;
          text b " ";
          factor b r
      | Over (l, r) ->
          continued l;
          text b "/";
          factor b r
      | Unit_name _ | To _ ->
          text b " ";
          unit_to b u
    in
    continued u

(* {1 Programs} *)

let names b list = enclosed b " (" ")" (name b) list

let header b (h : header) =
  text b ("module " ^ h.module_name.text);
  Option.iter (names b) h.exports;
  text b " where\n"

let import b (i : import) =
  text b "import ";
  if i.qualified then text b "qualified ";
  text b i.module_.text;
  Option.iter (fun (x : name) -> text b (" as " ^ x.text)) i.alias;
  Option.iter (names b) i.items;
  text b "\n"

let program ppf (p : program) =
  let b = Buffer.create 4096 in
  Option.iter (header b) p.header;
  if p.header <> None && p.imports <> [] then text b "\n";
  List.iter (import b) p.imports;
  let after_signature = ref false in
  List.iteri
    (fun i (d : declaration) ->
      if (i > 0 || p.header <> None || p.imports <> []) && not !after_signature then text b "\n";
      declaration b 0 d;
      text b "\n";
      after_signature := match d.desc with Signature _ -> true | _ -> false)
    p.declarations;
  Format.pp_print_string ppf (Buffer.contents b)
