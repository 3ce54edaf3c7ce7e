/* The grammar of one top-level item.

   Layout has been resolved (see layout.mli): blocks are enclosed in OPEN and
   CLOSE, items are separated by SEMICOLON, and END follows each top-level item.
   Patterns are parsed as terms (see surface.mli). Lists that may be long are
   left-recursive and have their last element first. */

%{
open Basis
open Ir
open Surface
open Build

let term location desc : term = { desc; span = span location }
let expression location desc = term location (Expression desc)
let ty location desc : Ir.ty = { desc; span = span location }
let measured location desc : Ir.unit_ = { desc; span = span location }
let expr = Term.to_expr
%}

%token <string> LOWER UPPER
%token <string * string> QUALIFIED_LOWER QUALIFIED_UPPER
%token <string> FIELD "a `.name` without spaces around it"
%token <string * bool> NUMBER
%token <string> STRING
%token <string> OPERATOR
%token <string> DOC
%token <Ir.claim> CLAIM "`assert` or `assume` at the start of a definition, followed by a string"
%token <Ir.check> CHECK "`test` or `trial` at the start of a definition, followed by a string"
%token MINUS SLASH STAR CARET
%token LPAREN RPAREN LBRACE RBRACE
%token UNIT_BRACKET "a `[` directly after a name or number"
%token LBRACKET RBRACKET
%token COMMA BACKTICK UNDERSCORE AT BACKSLASH EQUAL BAR
%token ARROW LEFT_ARROW TAIL DOUBLE_ARROW DOUBLE_COLON
%token LAMBDA_CASE "`\\case`"
%token LET IN WHERE DO OF CASE IF THEN ELSE PROC REC
%token MODULE IMPORT QUALIFIED AS DATA TYPE UNIT PRIMITIVE FOREIGN PARAM CLASS INSTANCE
%token OPEN CLOSE SEMICOLON END
/* Tokens that no program contains: */
%token BAD
%token <string> RESERVED

/* A `where` or `-<` after the body of a `proc` belongs to the innermost one. */
%nonassoc innermost_proc
%nonassoc WHERE TAIL

%start <Surface.item> item
%%

item:
| END { Nothing }
| h = header END { Header h }
| i = import END { Import i }
| d = declaration END { Declaration d }

/* Names */

lower:
| x = LOWER { name $loc x }
| QUALIFIED { name $loc "qualified" }
| AS { name $loc "as" }

upper:
| x = UPPER { name $loc x }

symbol:
| x = OPERATOR { name $loc x }
| SLASH { name $loc "/" }
| STAR { name $loc "*" }
| CARET { name $loc "^" }

operator:
| x = symbol { x }
| MINUS { name $loc "-" }

variable:
| x = lower { x }
| LPAREN x = operator RPAREN { x }

constructor_name:
| x = upper { unqualified x }
| x = QUALIFIED_UPPER { qualified $loc x }

infix:
| x = operator { unqualified x }
| BACKTICK x = lower BACKTICK { { (unqualified x) with span = span $loc } }
| BACKTICK x = QUALIFIED_LOWER BACKTICK { { (qualified $loc(x) x) with span = span $loc } }

comma_separated(X):
| x = X { [ x ] }
| xs = comma_separated(X) COMMA x = X { x :: xs }

many(X):
| { [] }
| xs = many(X) x = X { x :: xs }

some(X):
| x = X { [ x ] }
| xs = some(X) x = X { x :: xs }

block(X):
| OPEN xs = items(X) CLOSE { List.rev xs }

items(X):
| { [] }
| x = X { [ x ] }
| xs = items(X) SEMICOLON { xs }
| xs = items(X) SEMICOLON x = X { x :: xs }

/* Modules */

header:
| MODULE module_name = upper exports = option(names) WHERE
    { { module_name; exports; span = span $loc } }

names:
| LPAREN RPAREN { [] }
| LPAREN xs = comma_separated(name_in_list) RPAREN { List.rev xs }

name_in_list:
| x = variable { x }
| x = upper { x }

import:
| IMPORT module_ = upper alias = option(alias) items = option(names)
    { { module_; qualified = false; alias; items; span = span $loc } }
| IMPORT QUALIFIED module_ = upper alias = option(alias) items = option(names)
    { { module_; qualified = true; alias; items; span = span $loc } }

alias:
| AS x = upper { x }

/* Declarations */

declaration:
| doc = option(DOC) desc = declaration_desc { { desc; doc; span = span $loc(desc) } }

declaration_desc:
| d = local_desc { d }
| TYPE name = upper parameters = parameters EQUAL body = ty { Type_alias { name; parameters;
  body } }
| TYPE name = upper parameters = parameters EQUAL body = size { Type_alias { name; parameters;
  body } }
| DATA name = upper parameters = parameters EQUAL constructors = constructors
    { Data { name; parameters; constructors = List.rev constructors } }
| UNIT name = unit_name { Base_unit name }
| UNIT name = unit_name EQUAL factors = product { scaled_unit ~name factors }
| CLASS head = class_head members = members { class_ (fst head) (snd head) members }
| INSTANCE head = class_head members = members { instance (fst head) (snd head) members }
| PRIMITIVE s = signature { Primitive s }
| kind = CHECK label = text EQUAL value = chain { Check { kind; label; value = expr value } }
| PARAM name = variable DOUBLE_COLON ty = qualified_type EQUAL value = chain
    { Parameter { name; ty; value = expr value } }
| FOREIGN name = variable DOUBLE_COLON ty = qualified_type EQUAL symbol = text
    { Foreign (Foreign_value { kind = Foreign_function; name; ty; symbol }) }
| FOREIGN word = lower name = variable DOUBLE_COLON ty = qualified_type EQUAL symbol = text
    { foreign_signal_function ~word name ty symbol }
| FOREIGN TYPE name = upper EQUAL c_type = text word = option(lower)
    { foreign_type name c_type ~word }
| FOREIGN word = lower header = text { foreign_include ~word header }

text:
| x = STRING { name $loc x }

class_head:
| t = type_application { ([], t) }
| c = type_application DOUBLE_ARROW t = type_application { (context c, t) }

local:
| doc = option(DOC) desc = local_desc { { desc; doc; span = span $loc(desc) } }

locals:
| ds = block(local) { declarations ds }

local_desc:
| s = signature { Signature s }
| kind = CLAIM label = text condition = chain { Claim { kind; label; condition =
  expr condition } }
| left = chain body = body where = where { Binding { left = Term.to_left left; right = { body;
  where }; span = span $loc } }

signature:
| names = comma_separated(variable) DOUBLE_COLON ty = qualified_type { { names = List.rev names;
  ty } }

body:
| EQUAL e = chain { Plain (expr e) }
| guards = some(guard) { Guarded (List.rev guards) }

guard:
| BAR condition = chain EQUAL e = chain { (expr condition, expr e) }

members:
| { [] }
| WHERE ds = locals { ds }

where:
| { [] }
| WHERE ds = locals { where $loc($1) ds }

parameters:
| types = many(lower) { { units = []; types = List.rev types } }
| UNIT_BRACKET units = comma_separated(lower) RBRACKET types = many(lower)
    { { units = List.rev units; types = List.rev types } }

constructors:
| c = constructor { [ c ] }
| cs = constructors BAR c = constructor { c :: cs }

constructor:
| doc = option(DOC) name = upper fields = fields
    { { name; fields; span = Span.merge name.span (span $loc(fields)); doc } }

fields:
| ts = many(simple_type) { Positional (List.rev ts) }
| LBRACE fields = field_groups RBRACE { Named (List.rev fields) }

field_groups:
| fs = field_group { List.rev fs }
| fs = field_groups COMMA gs = field_group { List.rev_append gs fs }

field_group:
| names = comma_separated(lower) DOUBLE_COLON t = ty { List.rev_map (fun x -> (x, t)) names }

/* Terms */

chain:
| t = plain { t }
| t = sequence { t }

/* Any expression except a bare `do`, which is the proc's body after `proc x ->`. */
plain:
| t = application { t }
| t = open_ended { t }
| steps = some(step) t = last { Operators.group steps t }

sequence:
| DO statements = block(statement) { expression $loc (task_body $loc statements) }

step:
| operand = application operator = infix { Operand { operand; operator } }
| MINUS { Minus (span $loc) }

last:
| t = application { t }
| t = open_ended { t }
| t = sequence { t }

open_ended:
| BACKSLASH parameters = some(argument) ARROW body = chain
    { expression $loc
        (Lambda { parameters = List.rev_map Term.to_pattern parameters; body = expr body }) }
| LAMBDA_CASE branches = block(branch) { expression $loc (Lambda_case branches) }
| LET bindings = locals IN body = chain { expression $loc (Let { bindings; body = expr body }) }
| IF condition = chain THEN then_ = chain ELSE else_ = chain
    { expression $loc (If { condition = expr condition; then_ = expr then_; else_ = expr else_ }) }
| CASE scrutinee = chain OF branches = block(branch)
    { expression $loc (Case { scrutinee = expr scrutinee; branches }) }
| PROC input = argument ARROW body = proc_body
    { expression $loc (Proc { input = Term.to_pattern input; body }) }

application:
| t = argument { t }
| head = argument arguments = some(argument)
    { term $loc (Application { head; arguments = List.rev arguments }) }

argument:
| t = primary { t }
| x = lower AT t = primary { term $loc (As (x, t)) }

primary:
| t = atom { t }
| t = primary x = FIELD { expression $loc (Field { record = expr t; field = field $loc(x) x }) }
| before = primary LBRACE fields = comma_separated(field) RBRACE
    { term $loc (Braces { before; fields = List.rev fields }) }

field:
| x = lower EQUAL t = chain { (x, t) }
| x = lower { (x, { desc = Variable (unqualified x); span = x.span }) }

atom:
| x = variable
    { let x = variable $loc x in { desc = Variable x; span = x.span } }
| x = QUALIFIED_LOWER { term $loc (Variable (qualified $loc x)) }
| c = constructor_name { term $loc (Constructor c) }
| n = number { term $loc (Number n) }
| s = STRING { expression $loc (String s) }
| UNDERSCORE { term $loc Wildcard }
| LPAREN RPAREN { term $loc (Tuple []) }
| LPAREN t = chain RPAREN { term $loc (Parenthesized t) }
| LPAREN places = places RPAREN { term $loc (tuple (List.rev places)) }
| LBRACKET RBRACKET { term $loc (Array []) }
| LBRACKET ts = comma_separated(chain) RBRACKET { term $loc (Array (List.rev ts)) }
| LPAREN t = chain DOUBLE_COLON ty = qualified_type RPAREN
    { expression $loc (Annotated { expr = expr t; ty }) }
| LPAREN t = application operator = infix RPAREN
    { Operators.left_section ~span:(span $loc) [] t operator }
| LPAREN steps = some(step) t = application operator = infix RPAREN
    { Operators.left_section ~span:(span $loc) steps t operator }
| LPAREN operator = section_operator t = last RPAREN
    { Operators.right_section ~span:(span $loc) operator [] t }
| LPAREN operator = section_operator steps = some(step) t = last RPAREN
    { Operators.right_section ~span:(span $loc) operator steps t }

/* The elements of a tuple, with at least one comma. A missing element makes it a tuple section. */
places:
| x = option(chain) COMMA y = option(chain) { [ y; x ] }
| xs = places COMMA x = option(chain) { x :: xs }

section_operator:
| x = symbol { unqualified x }
| BACKTICK x = lower BACKTICK { { (unqualified x) with span = span $loc } }
| BACKTICK x = QUALIFIED_LOWER BACKTICK { { (qualified $loc(x) x) with span = span $loc } }

number:
| n = NUMBER { let digits, decimal = n in { digits; decimal; unit_ = None } }
| n = NUMBER UNIT_BRACKET factors = product RBRACKET
    { let digits, decimal = n in { digits; decimal; unit_ = Some (product factors) } }

branch:
| pattern = chain body = branch_body where = where
    { { pattern = Term.to_pattern pattern; body; where; span = span $loc } : branch }

branch_body:
| ARROW e = chain { Always (expr e) }
| guards = some(branch_guard) { If_guards (List.rev guards) }

branch_guard:
| BAR condition = chain ARROW e = chain { (expr condition, expr e) }

/* Signal functions */

proc_body:
| output = plain %prec innermost_proc { Output { output = expr output; equations = [] } }
| output = plain WHERE ds = locals { Output { output = expr output;
  equations = where $loc($2) ds } }
| f = plain TAIL t = chain
    { Command { signal_function = expr f; argument = expr t; span = span $loc } }
| DO statements = block(statement) { do_body $loc statements }

command:
| f = chain TAIL t = chain
    { { signal_function = expr f; argument = expr t; span = span $loc } }

statement:
| left = chain LEFT_ARROW right = chain { Arrow_bind { left; right = expr right } }
| left = chain LEFT_ARROW command = command { Command_bind { left; command } }
| command = command { Bare_command command }
| t = chain { Bare_expression t }
| LET ds = locals { Let ds }
| REC ss = block(statement) { Rec ss }

/* Types */

qualified_type:
| ty = ty { { context = []; ty } }
| c = type_application DOUBLE_ARROW ty = ty { { context = context c; ty } }

ty:
| t = type_application { t }
| t = type_application ARROW result = ty { ty $loc (Function (t, result)) }

type_application:
| t = simple_type { t }
| head = type_head arguments = some(simple_type)
    { let name, units = head in
      ty $loc (Type { name; units; arguments = List.rev arguments }) }

type_head:
| name = constructor_name { (name, None) }
| name = constructor_name UNIT_BRACKET units = comma_separated(unit_) RBRACKET
    { (name, Some (List.rev units)) }

simple_type:
| head = type_head
    { let name, units = head in ty $loc (Type { name; units; arguments = [] }) }
| x = lower { ty $loc (Type_variable x) }
| n = NUMBER { ty $loc (Size (size $loc n)) }
| name = lower UNIT_BRACKET unit_ = unit_ RBRACKET
    { ty $loc (Representation { name; unit_ }) }
| LPAREN RPAREN { ty $loc (Tuple_type []) }
| LPAREN t = ty RPAREN { t }
| LPAREN t = size RPAREN { t }
| LPAREN t = ty COMMA ts = comma_separated(ty) RPAREN
    { ty $loc (Tuple_type (t :: List.rev ts)) }

/* Arithmetic on sizes: `Array (2 * N - 1) Float` */

size:
| t = size_product { t }
| t = size_sum { t }

size_sum:
| left = size_term operator = sign right = size_term
    { ty $loc (Size_operation { operator; left; right }) }
| left = size_sum operator = sign right = size_term
    { ty $loc (Size_operation { operator; left; right }) }

size_term:
| t = type_application { t }
| t = size_product { t }

size_product:
| left = type_application STAR right = type_application
    { ty $loc (Size_operation { operator = Times_sizes; left; right }) }
| left = size_product STAR right = type_application
    { ty $loc (Size_operation { operator = Times_sizes; left; right }) }

sign:
| MINUS { Minus_sizes }
| x = OPERATOR { sign_of_sizes $loc x }

/* Units */

unit_name:
| x = lower { x }
| x = upper { x }

unit_:
| factors = product { product factors }

product:
| f = factor { [ { factor = f; over = false; span = span $loc } ] }
| fs = product f = factor { { factor = f; over = false; span = span $loc(f) } :: fs }
| fs = product STAR f = factor { { factor = f; over = false; span = span $loc(f) } :: fs }
| fs = product SLASH f = factor { { factor = f; over = true; span = span $loc(f) } :: fs }

factor:
| n = NUMBER { let digits, decimal = n in Amount { digits; decimal } }
| u = measure { Measure u }
| u = measure CARET exponent = exponent
    { Measure (measured $loc (To (u, exponent))) }

measure:
| x = unit_name { measured $loc (Unit_name x) }
| LPAREN u = unit_ RPAREN { u }

exponent:
| n = whole { exponent $loc ~negative:false n ~over:"1" }
| MINUS n = whole { exponent $loc ~negative:true n ~over:"1" }
| LPAREN n = whole RPAREN { exponent $loc ~negative:false n ~over:"1" }
| LPAREN MINUS n = whole RPAREN { exponent $loc ~negative:true n ~over:"1" }
| LPAREN n = whole SLASH d = whole RPAREN { exponent $loc ~negative:false n ~over:d }
| LPAREN MINUS n = whole SLASH d = whole RPAREN { exponent $loc ~negative:true n ~over:d }

whole:
| n = NUMBER
    { match n with
      | digits, false -> digits
      | digits, true ->
          Reject.because (Exponent_not_whole { at = span $loc; digits }) }
