open Basis
open Surface

type side = Left | Right | Neither

let table =
  [
    (9, Right, [ "." ]);
    (9, Left, [ "!" ]);
    (8, Right, [ "^"; "**" ]);
    (7, Left, [ "*"; "/"; "*^"; ".&." ]);
    (6, Left, [ "+"; "-"; "^+^"; "^-^" ]);
    (5, Left, [ ".|." ]);
    (4, Neither, [ "=="; "/="; "<"; "<="; ">"; ">=" ]);
    (3, Right, [ "&&"; "***"; "&&&" ]);
    (2, Right, [ "||" ]);
    (1, Right, [ ">>>"; "<<<" ]);
    (0, Right, [ "$" ]);
  ]

let symbols = List.concat_map (fun (_, _, symbols) -> symbols) table

let precedences =
  List.concat_map
    (fun (level, side, symbols) -> List.map (fun s -> (s, (level, side))) symbols)
    table
  |> List.to_seq |> String_table.of_seq

(* As in Haskell, names in backticks have the same precedence as [!], except for the names listed
   here. *)
let precedence (operator : Ir.qualified) =
  match operator.name.text with
  | "shiftL" | "shiftR" -> (8, Left)
  | "div" | "mod" -> (7, Left)
  | "xor" -> (6, Left)
  | text -> Option.value (String_table.find_opt precedences text) ~default:(9, Left)

let minus_level = 6
let comparison_level = 4

type pending =
  | Binary of { left : term; operator : Ir.qualified; level : int; side : side }
  | Unary of Span.t

let literal_exponent (base : term) (operator : Ir.qualified) (right : term) =
  let reject () = Reject.because (Exponent { base; operator; exponent = right }) in
  let rec read negative (t : term) =
    match t.desc with
    | Parenthesized t -> read negative t
    | Negated t when not negative -> read true t
    | Number { digits; decimal = false; unit_ = None } -> (
        match Build.whole digits with Some n -> if negative then -n else n | None -> reject ())
    | Number _ | Negated _ | Expression _ | Wildcard | As _ | Variable _ | Constructor _ | Tuple _
    | Array _ | Application _ | Braces _ ->
        reject ()
  in
  read false right

let apply (left : term) (operator : Ir.qualified) (right : term) : term =
  let span = Span.merge left.span right.span in
  let desc : Ir.expr_desc =
    match operator with
    | { qualifier = None; name = { text = "^"; _ }; _ } ->
        let exponent = literal_exponent left operator right in
        Power { base = Term.to_expr left; exponent }
    | { qualifier = None; name = { text = "$"; _ }; _ } ->
        Apply (Term.to_expr left, Term.to_expr right)
    | _ -> Binary { operator; left = Term.to_expr left; right = Term.to_expr right }
  in
  { desc = Expression desc; span }

let negate span (operand : term) : term =
  { desc = Negated operand; span = Span.merge span operand.span }

let reject_two left first middle second right =
  let compare = fst (precedence second) = comparison_level in
  Reject.because (Two_operators { left; first; middle; second; right; compare })

(* Operator-precedence parsing with an explicit stack. [reduce] applies the operators on the stack
   that bind tighter than an operator of [level]. [right]: the operand after the operator [next]. *)
let rec reduce stack operand level side next ~right =
  match stack with
  | Binary b :: rest ->
      if b.level > level || (b.level = level && b.side = Left && side = Left) then
        reduce rest (apply b.left b.operator operand) level side next ~right
      else if b.level = level && not (b.side = Right && side = Right) then
        reject_two b.left b.operator operand next right
      else (stack, operand)
  | Unary at :: rest ->
      if minus_level > level || (minus_level = level && side = Left) then
        reduce rest (negate at operand) level side next ~right
      else (stack, operand)
  | [] -> (stack, operand)

let push stack next = function
  | Minus at ->
      (match stack with
      | Binary b :: _ when b.level >= minus_level ->
          Reject.because (Minus_after { operator = b.operator; at; operand = next })
      | Unary first :: _ -> Reject.because (Two_minuses { first; second = at; operand = next })
      | Binary _ :: _ | [] -> ());
      Unary at :: stack
  | Operand { operand; operator } ->
      let level, side = precedence operator in
      let stack, left = reduce stack operand level side operator ~right:next in
      Binary { left; operator; level; side } :: stack

let rec finish stack operand =
  match stack with
  | [] -> operand
  | Binary b :: rest -> finish rest (apply b.left b.operator operand)
  | Unary at :: rest -> finish rest (negate at operand)

(* The next operand. *)
let rec next last = function
  | Operand { operand; _ } :: _ -> operand
  | Minus _ :: rest -> next last rest
  | [] -> last

let rec push_all last stack = function
  | [] -> stack
  | step :: rest -> push_all last (push stack (next last rest) step) rest

let group steps last =
  match steps with [] -> last | _ -> finish (push_all last [] (List.rev steps)) last

(* The operators left on the stack after the last step are the outermost ones in the operand. The
   one at the bottom binds most loosely. *)
let loosest stack =
  match List.rev stack with
  | [] -> None
  | Binary b :: _ -> Some (b.level, b.side, Some b.operator)
  | Unary _ :: _ -> Some (minus_level, Left, None)

let check_section (operator : Ir.qualified) wanted stack =
  let level, side = precedence operator in
  match loosest stack with
  | None -> ()
  | Some (inner_level, inner_side, inner) ->
      if inner_level < level || (inner_level = level && not (side = wanted && inner_side = wanted))
      then Reject.because (Section { operator; inner })

let section ~span desc : term = { desc = Expression desc; span }

let left_section ~span steps last operator =
  let stack = push_all last [] (List.rev steps) in
  check_section operator Left stack;
  section ~span (Left_section { left = Term.to_expr (finish stack last); operator })

let right_section ~span operator steps last =
  let stack = push_all last [] (List.rev steps) in
  check_section operator Right stack;
  section ~span (Right_section { operator; right = Term.to_expr (finish stack last) })

let groups_inside ~outer ~side inner =
  let outer_level, outer_side = precedence outer and level, _ = precedence inner in
  level > outer_level
  || level = outer_level
     &&
     match (side, outer_side) with
     | `Left, Left | `Right, Right -> true
     | (`Left | `Right), (Left | Right | Neither) -> false
