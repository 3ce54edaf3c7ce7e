open Choice
open Scope

let f = Printf.sprintf
let typed = Constant.annotated
let literal = Constant.literal
let variables_of s ty = List.filter (fun (_, t) -> t = ty) s.variables
let functions_to s ty = List.filter (fun (_, _, result) -> result = ty) s.functions

let rec expression s fuel ty =
  let atom () =
    match variables_of s ty with
    | _ :: _ as all when not (chance s.random 6) -> fst (one_of s.random all)
    | _ -> ( match (ty : Type.t) with Tuple _ | Array _ -> parts s fuel ty | _ -> literal s ty)
  in
  if fuel <= 0 then atom ()
  else
    let weight yes n = if yes then n else 0 in
    let make =
      weighted s.random
        [
          (4, atom);
          (10, fun () -> by_type s (fuel - 1) ty);
          (2, fun () -> conditional s (fuel - 1) ty);
          (4, fun () -> case s (fuel - 1) ty);
          (1, fun () -> let_ s (fuel - 1) ty);
          ((if fuel > 1 then s.bias.chains else 0), fun () -> chain s ty);
          (4, fun () -> polymorphic s (fuel - 1) ty);
          (2, fun () -> of_array s (fuel - 1) ty);
          (2, fun () -> higher_order s (fuel - 1) ty);
          (1, fun () -> field s (fuel - 1) ty);
          (weight (functions_to s ty <> []) 4, fun () -> call s (fuel - 1) ty);
          ( weight (s.run <> None) 4,
            fun () -> match s.run with Some run -> run s (fuel - 1) ty | None -> atom () );
        ]
    in
    make ()

(* The scope of an expression that may not be evaluated at every instant: it must not contain
   stateful instances. *)
and elsewhere s = { s with run = (if s.run = None then None else s.senses) }
and unary s fuel name ty = f "(%s %s)" name (expression s fuel ty)
and binary s fuel name ty = f "(%s %s %s)" name (expression s fuel ty) (expression s fuel ty)
and infix s fuel operator ty = f "(%s %s %s)" (expression s fuel ty) operator (expression s fuel ty)

and extreme s fuel ty =
  let name = one_of s.random [ "min"; "max" ] in
  f "(%s %s %s)" name (typed (expression s fuel ty) ty) (expression s fuel ty)

and parts s fuel (ty : Type.t) =
  match ty with
  | Tuple [ a; b ] when chance s.random 12 ->
      note s "tuple section";
      f "((, %s) %s)" (expression (elsewhere s) fuel b) (expression s fuel a)
  | Tuple parts -> f "(%s)" (String.concat ", " (List.map (expression s fuel) parts))
  | Array (n, t) -> Constant.array (List.init n (fun _ -> expression s fuel t))
  | Float | Measure _ | Int | Bool | Data _ -> expression s fuel ty

and by_type s fuel (ty : Type.t) =
  match ty with
  | (Float | Int | Bool) when chance s.random 10 -> by_rule s fuel ty
  | Float -> float s fuel
  | Int -> int s fuel
  | Bool -> bool s fuel
  | Measure u -> quantity s fuel u
  | Tuple _ -> parts s fuel ty
  | Array (n, t) -> computed_array s fuel n t
  | Data _ when Type.event_payload ty <> None && not (chance s.random 4) ->
      event s fuel (Option.get (Type.event_payload ty))
  | Data data ->
      let c = one_of s.random data.constructors in
      let arguments = List.map (fun (_, t) -> expression s fuel t) c.fields in
      if Type.is_record data && chance s.random 3 then (
        let name, t = one_of s.random c.fields in
        note s "record update";
        let record = typed (expression s fuel ty) ty and value = expression s fuel t in
        if chance s.random 4 then (
          note s "pun in an expression";
          f "(let %s = %s in %s { %s })" name value record name)
        else f "(%s { %s = %s })" record name value)
      else typed (Constant.construct data c arguments) ty

(* Expressions that the compiler has algebraic rules for: neutral and absorbing elements, and one
   operation on the same two numbers in both orders. *)
and by_rule s fuel (ty : Type.t) =
  match ty with
  | Bool when chance s.random 2 ->
      let ty = one_of s.random [ Type.Float; Float; Int ] in
      f "(%s %s %s)" (of_literals s ty) (comparison s) (of_literals s ty)
  | Bool -> with_itself s fuel
  | _ -> if chance s.random 4 then of_literals s ty else by_numbers s fuel ty

and comparison s = one_of s.random [ "=="; "/="; "<"; "<="; ">"; ">=" ]

(* Compares a number that is often NaN with itself. *)
and with_itself s fuel =
  let a = fresh s "a" and e = typed (expression s fuel Type.Float) Type.Float in
  let number = one_of s.random [ e; f "sqrt %s" e; f "log %s" e; f "(%s / %s)" e e ] in
  f "((\\%s -> %s %s %s) (%s))" a a (comparison s) a number

(* An operation that the compiler evaluates itself. *)
and of_literals s (ty : Type.t) =
  note s "operation on literals";
  let operand () =
    if chance s.random 3 then of_literals s ty
    else typed (if ty = Float && chance s.random 3 then Constant.odd_float s else literal s ty) ty
  in
  let operators =
    match ty with
    | Int -> [ "+"; "-"; "*"; "`div`"; "`mod`"; "`shiftL`"; "`shiftR`" ]
    | _ -> [ "+"; "-"; "*"; "/" ]
  in
  let operator = one_of s.random ([ "`max`"; "`max`"; "`min`"; "`min`" ] @ operators) in
  f "(%s %s %s)" (operand ()) operator (operand ())

and by_numbers s fuel (ty : Type.t) =
  let point = match ty with Int -> "" | _ -> ".0" in
  let zero = one_of s.random [ "0" ^ point; "0" ^ point; f "(-0%s)" point ] and one = "1" ^ point in
  if chance s.random 3 then (
    note s "both orders";
    let operator = one_of s.random [ "+"; "-"; "*" ] and outer = one_of s.random [ "-"; "*" ] in
    let a = fresh s "a" and b = fresh s "b" in
    f "((\\%s %s -> (%s %s %s) %s (%s %s %s)) %s %s)" a b a operator b outer b operator a
      (typed (expression s fuel ty) ty)
      (typed (expression s fuel ty) ty))
  else
    let e = typed (expression s fuel ty) ty in
    let same operator number =
      one_of s.random [ f "(%s %s %s)" e operator number; f "(%s %s %s)" number operator e ]
    in
    let limited () = f "(%s %s %s)" (one_of s.random [ "min"; "max" ]) zero e in
    one_of s.random
      [
        limited ();
        limited ();
        same "+" zero;
        same "+" zero;
        same "-" zero;
        same "*" one;
        same "*" zero;
        f "(%s - %s)" e e;
      ]

(* A function that may use the values of the instant. *)
and function_ s fuel arguments result =
  let inside = elsewhere s in
  let patterns = List.map (Pattern.any inside) arguments in
  f "(\\%s -> %s)"
    (String.concat " " (List.map fst patterns))
    (expression (bind (List.concat_map snd patterns) inside) fuel result)

and any_array s = (1 + Random.State.int s.random 4, any_type s)
and some_array s fuel (n, t) = typed (expression s fuel (Array (n, t))) (Array (n, t))

and computed_array s fuel n t =
  let whole : Type.t = Array (n, t) in
  let other = any_type s and fuel = fuel - 1 in
  match Random.State.int s.random 9 with
  | 0 -> f "(map %s %s)" (function_ s fuel [ other ] t) (some_array s fuel (n, other))
  | 1 -> f "(imap %s %s)" (function_ s fuel [ Int; other ] t) (some_array s fuel (n, other))
  | 2 ->
      let third = any_type s in
      f "(zipWith %s %s %s)"
        (function_ s fuel [ other; third ] t)
        (some_array s fuel (n, other))
        (some_array s fuel (n, third))
  | 3 ->
      f "(scanl %s %s %s)"
        (function_ s fuel [ t; other ] t)
        (expression s fuel t)
        (some_array s fuel (n, other))
  | 4 -> f "(replace %s %s %s)" (index s fuel) (expression s fuel t) (some_array s fuel (n, t))
  | 5 -> typed (f "generate %s" (function_ s fuel [ Int ] t)) whole
  | 6 ->
      let some = some_array s fuel (1 + Random.State.int s.random 4, t) in
      typed (f "%s %s" (one_of s.random [ "take"; "drop" ]) some) whole
  | _ -> parts s fuel whole

and index s fuel =
  if chance s.random 2 then expression s fuel Int
  else one_of s.random [ "0"; "1"; "2"; "3"; "(-1)"; "4" ]

(* An element of an array, or a value computed from one. *)
and of_array s fuel ty =
  let own = (1 + Random.State.int s.random 4, ty) and ((_, element) as other) = any_array s in
  let key : Type.t =
    match Random.State.int s.random 4 with
    | 0 -> Int
    | 1 -> Measure (Type.any_measure s.random)
    | _ -> Float
  in
  match (Random.State.int s.random 8, (ty : Type.t)) with
  | 0, Int -> f "(length %s)" (some_array s fuel other)
  | (0 | 1), Bool ->
      f "(%s %s %s)"
        (one_of s.random [ "any"; "all" ])
        (function_ s fuel [ element ] Bool)
        (some_array s fuel other)
  | (0 | 1 | 2), _ ->
      f "(foldl %s %s %s)"
        (function_ s fuel [ ty; element ] ty)
        (expression s fuel ty) (some_array s fuel other)
  | 3, _ when chance s.random 3 ->
      f "(bestBy %s %s %s)"
        (function_ s fuel [ key; key ] Bool)
        (function_ s fuel [ ty ] key) (some_array s fuel own)
  | (3 | 4), _ ->
      f "(%s %s %s)"
        (one_of s.random [ "minimumBy"; "maximumBy" ])
        (function_ s fuel [ ty ] key) (some_array s fuel own)
  | 5, (Float | Measure _ | Int) when chance s.random 2 ->
      let name = if ty = Int || chance s.random 2 then "sum" else "mean" in
      f "(%s %s)" name (some_array s fuel own)
  | 5, _ -> f "(%s ! %d)" (some_array s fuel own) (Random.State.int s.random (fst own))
  | _, _ -> f "(at %s %s %s)" (index s fuel) (expression s fuel ty) (some_array s fuel own)

and quantity s fuel ({ metres; seconds } as u) =
  let ty = Type.Measure u in
  let part () = Random.State.int s.random 3 - 1 in
  match Random.State.int s.random 10 with
  | 0 | 1 -> infix s fuel (one_of s.random [ "+"; "-" ]) ty
  | 2 -> unary s fuel (one_of s.random [ "negate"; "abs" ]) ty
  | 3 -> extreme s fuel ty
  | 4 -> binary s fuel (one_of s.random [ "hypot"; "limit"; "deadband" ]) ty
  | 5 ->
      let square = Type.measure ~metres:(2 * metres) ~seconds:(2 * seconds) in
      f "(sqrt %s)" (typed (expression s fuel square) square)
  | 6 | 7 ->
      let m = part () and n = part () in
      let left = Type.measure ~metres:m ~seconds:n
      and right = Type.measure ~metres:(metres - m) ~seconds:(seconds - n) in
      f "(%s * %s)" (typed (expression s fuel left) left) (typed (expression s fuel right) right)
  | _ ->
      let m = part () and n = part () in
      let above = Type.measure ~metres:(metres + m) ~seconds:(seconds + n)
      and below = Type.measure ~metres:m ~seconds:n in
      f "(%s / %s)" (typed (expression s fuel above) above) (typed (expression s fuel below) below)

and event s fuel payload =
  let ty = Type.event payload in
  let other = any_type s in
  let any event = typed (expression s fuel (Type.event event)) (Type.event event) in
  let function_ arguments result = function_ s fuel arguments result in
  match (Random.State.int s.random 9, payload) with
  | 0, _ -> f "(mapE %s %s)" (function_ [ other ] payload) (any other)
  | 1, _ -> f "(tag %s %s)" (any other) (expression s fuel payload)
  | 2, _ -> f "(filterEvent %s %s)" (function_ [ payload ] Bool) (any payload)
  | 3, _ -> f "(gate %s %s)" (any payload) (expression s fuel Bool)
  | 4, _ ->
      f "(mergeBy %s %s %s)" (function_ [ payload; payload ] payload) (any payload) (any payload)
  | 5, _ -> f "(%s %s %s)" (one_of s.random [ "mergeE"; "mergeR" ]) (any payload) (any payload)
  | _, Tuple [ x; y ] -> f "(pairEvents %s %s)" (any x) (any y)
  | _, _ -> typed (f "Event %s" (expression s fuel payload)) ty

(* An expression that is nearly the same as its operand or as a constant. Often the compiler must
   not simplify the expression to that. *)
and nearly_nothing s fuel ty =
  let e = expression s fuel ty in
  match (ty : Type.t) with
  | Float ->
      let zero = one_of s.random [ "0.0"; "(-0.0)" ] in
      one_of s.random
        [
          f "(%s + %s)" e zero;
          f "(%s + %s)" zero e;
          f "(%s - %s)" e zero;
          f "(%s - %s)" zero e;
          f "(%s * 1.0)" e;
          f "(1.0 * %s)" e;
          f "(%s * %s)" e zero;
          f "(%s / 1.0)" e;
          f "(%s / %s)" zero e;
          f "(%s * (-1.0))" e;
          f "(%s / 2.0)" e;
          f "(max %s %s)" e zero;
          f "(max %s %s)" zero e;
          f "(min %s %s)" e zero;
          f "(min %s %s)" zero e;
          f "(max %s (min %s %s))" zero e zero;
          f "(limit %s %s)" zero e;
          f "(1.0 / %s)" e;
        ]
  | _ ->
      one_of s.random
        [
          f "(%s + 0)" e;
          f "(0 - %s)" e;
          f "(%s * 1)" e;
          f "(%s * 0)" e;
          f "(0 * %s)" e;
          f "(div %s 1)" e;
          f "(mod %s 1)" e;
          f "(%s .&. (-1))" e;
          f "(shiftL %s 32)" e;
          f "(%s .|. %s)" e e;
          f "(xor %s %s)" e e;
          f "(shiftR %s (-1))" e;
          f "(div 0 %s)" e;
          f "(%s * (-1))" e;
          f "(div %s (-1))" e;
        ]

(* The same two operands in both orders, or an operand with itself. *)
and both_ways s ty operators =
  let operand () = typed (expression s 0 ty) ty in
  let x = operand () in
  let y = if chance s.random 4 then x else operand () in
  let operator = one_of s.random operators in
  (f "(%s %s %s)" x operator y, f "(%s %s %s)" y operator x)

and float s fuel =
  match Random.State.int s.random 19 with
  | 15 | 18 -> nearly_nothing s fuel Float
  | 16 | 17 ->
      let one, other = both_ways s Float [ "+"; "-"; "*"; "/" ] in
      (* The compiler computes even functions of x - y and y - x once. *)
      let outer = one_of s.random [ ""; ""; "abs "; "hypot 2 "; "sin " ] in
      let operator = one_of s.random [ "+"; "-"; "*"; "/" ] in
      f "((%s%s) %s (%s%s))" outer one operator outer other
  | 12 ->
      let u = Type.any_measure s.random in
      f "(%s / 1[%s])" (expression s fuel (Measure u)) (Type.unit_text u)
  | 14 ->
      let seconds = Type.Measure { metres = 0; seconds = 1 } in
      f "(nanoseconds %s)" (expression s fuel seconds)
  | 13 ->
      let ty = Type.Measure (Type.any_measure s.random) in
      f "(%s %s %s)" "atan2" (typed (expression s fuel ty) ty) (expression s fuel ty)
  | 0 | 1 | 2 | 3 -> infix s fuel (one_of s.random [ "+"; "-"; "*"; "/" ]) Float
  | 4 ->
      unary s fuel
        (one_of s.random [ "negate"; "abs"; "signum"; "sqrt"; "floorFloat"; "ceilingFloat" ])
        Float
  | 5 -> extreme s fuel Float
  | 6 ->
      let names = [ "sin"; "cos"; "tan"; "asin"; "acos"; "atan"; "exp"; "log" ] in
      unary s fuel (one_of s.random names) Float
  | 7 -> binary s fuel (one_of s.random [ "atan2"; "hypot"; "limit"; "deadband" ]) Float
  | 8 -> infix s fuel "**" Float
  | 9 ->
      let k = one_of s.random [ "0"; "1"; "2"; "3"; "5"; "6"; "13"; "(-1)"; "(-2)"; "(-7)" ] in
      f "(%s ^ %s)" (expression s fuel Float) k
  | 10 -> f "(- %s)" (expression s fuel Float)
  | _ -> unary s fuel "toFloat" Int

and int s fuel =
  match Random.State.int s.random 16 with
  | 13 -> binary s fuel (one_of s.random [ "shiftL"; "shiftR" ]) Int
  | 14 -> infix s fuel (one_of s.random [ ".&."; ".|."; "`xor`"; "`shiftL`"; "`shiftR`" ]) Int
  | 15 -> unary s fuel "complement" Int
  | 10 -> nearly_nothing s fuel Int
  | 11 | 12 ->
      let one, other = both_ways s Int [ "+"; "-"; "*"; "`div`"; "`mod`"; ".&."; ".|."; "`xor`" ] in
      f "(%s %s %s)" one (one_of s.random [ "+"; "-"; "*" ]) other
  | 0 | 1 | 2 -> infix s fuel (one_of s.random [ "+"; "-"; "*" ]) Int
  | 3 | 4 ->
      let name = one_of s.random [ "div"; "mod" ] in
      if chance s.random 8 then (
        note s "division by zero";
        f "(%s %s 0)" name (expression s fuel Int))
      else binary s fuel name Int
  | 5 -> unary s fuel (one_of s.random [ "negate"; "abs"; "signum" ]) Int
  | 6 -> extreme s fuel Int
  | 7 -> f "(%s ^ %s)" (expression s fuel Int) (one_of s.random [ "0"; "1"; "2"; "3"; "9" ])
  | n ->
      (* Removes the unit again by rounding to a whole number of units. *)
      let name = one_of s.random [ "round"; "floor"; "ceiling"; "truncate" ] in
      if n = 9 && chance s.random 3 then
        let u = Type.any_measure s.random in
        f "(div (%s %s) 1[%s])" name
          (typed (expression s fuel (Measure u)) (Measure u))
          (Type.unit_text u)
      else unary s fuel name Float

and bool s fuel =
  match Random.State.int s.random 11 with
  | 9 | 10 ->
      let ty = one_of s.random [ Type.Float; Float; Int; any_type s ] in
      let one, other = both_ways s ty [ "=="; "/="; "<"; "<="; ">"; ">=" ] in
      f "(%s %s %s)" one (one_of s.random [ "=="; "&&"; "||" ]) other
  | 8 ->
      let ty = Type.event (any_type s) in
      f "(isEvent %s)" (typed (expression s fuel ty) ty)
  | 0 -> unary s fuel "not" Bool
  | 1 | 2 -> infix s fuel (one_of s.random [ "&&"; "||" ]) Bool
  | n ->
      let ty = if n < 6 then one_of s.random [ Type.Float; Int ] else any_type s in
      let operator = one_of s.random [ "=="; "/="; "<"; "<="; ">"; ">=" ] in
      f "(%s %s %s)" (typed (expression s fuel ty) ty) operator (typed (expression s fuel ty) ty)

and conditional s fuel ty =
  let inside = elsewhere s in
  f "(if %s then %s else %s)" (expression s fuel Bool) (expression inside fuel ty)
    (expression inside fuel ty)

and case s fuel ty =
  let scrutinized = any_type s in
  let value = typed (expression s fuel scrutinized) scrutinized in
  let s = elsewhere s in
  let result bound = expression (bind bound s) fuel ty in
  let branch (text, bound) =
    match Random.State.int s.random 6 with
    | 0 ->
        let guard = expression (bind bound s) (fuel - 1) Bool in
        f "%s | %s -> %s | otherwise -> %s" text guard (result bound) (result bound)
    | 1 ->
        note s "guards that fall through";
        f "%s | %s -> %s; %s -> %s" text
          (expression (bind bound s) (fuel - 1) Bool)
          (result bound) text (result bound)
    | _ -> f "%s -> %s" text (result bound)
  in
  let rec shortened = function
    | first :: _ :: _ when chance s.random 5 -> [ first; ("_", []) ]
    | first :: others -> first :: shortened others
    | [] -> []
  in
  let branches = shortened (Pattern.cover s 2 scrutinized) in
  let text = String.concat "; " (List.map branch branches) in
  if chance s.random 6 then (
    note s "function by cases";
    f "((\\case %s) %s)" text value)
  else f "(case %s of %s)" value text

and let_ s fuel ty =
  let other = any_type s in
  let value = expression s fuel other in
  let text, bound = Pattern.any s other in
  f "(let %s = %s in %s)" text (typed value other) (expression (bind bound s) fuel ty)

(* Arrays and values computed from them, each with a name. Uses little fuel, or is left out,
   where its text would be repeated many times, as in a lambda. *)
and chain s ty =
  let makers = { Chain.expression; instances = None } in
  let bindings = Chain.make s makers (Chain.size s) in
  let equation { Chain.name; text; _ } = f "%s = %s" name text in
  f "(let %s in %s)"
    (String.concat "; " (List.map equation bindings))
    (Chain.result s makers bindings ty)

and lambda s fuel argument ty =
  match (argument, ty) with
  | (Type.Float, Type.Float | Int, Int) when chance s.random 4 ->
      note s "section";
      let operator = one_of s.random [ "+"; "*" ] and inside = elsewhere s in
      if chance s.random 2 then f "(%s %s)" operator (expression inside fuel ty)
      else f "(%s %s)" (expression inside fuel ty) operator
  | _ -> function_ s fuel [ argument ] ty

and polymorphic s fuel ty =
  let e ty = expression s fuel ty and other = any_type s in
  let two () = (any_type s, other) in
  match Random.State.int s.random 17 with
  | 13 when s.methods ->
      note s "method of a class";
      overloaded s fuel ty
  | 14 ->
      let first, second = two () in
      f "(curry %s %s %s)"
        (lambda s fuel (Tuple [ first; second ]) ty)
        (typed (e first) first)
        (typed (e second) second)
  | 15 ->
      let first, second = two () in
      f "(uncurry %s (%s, %s))"
        (function_ s fuel [ first; second ] ty)
        (typed (e first) first)
        (typed (e second) second)
  | 16 ->
      let first, second = two () in
      f "(flip %s %s %s)"
        (function_ s fuel [ first; second ] ty)
        (typed (e second) second)
        (typed (e first) first)
  | 12 -> f "(fromEvent %s %s)" (e ty) (e (Type.event ty))
  | 0 -> f "(choose %s %s %s)" (e Bool) (e ty) (e ty)
  | 1 -> f "(fst (%s, %s))" (e ty) (typed (e other) other)
  | 2 -> f "(snd (swap (%s, %s)))" (e ty) (typed (e other) other)
  | 3 -> f "(const %s %s)" (e ty) (typed (e other) other)
  | 4 -> f "(fromMaybe %s %s)" (e ty) (e (Type.maybe ty))
  | 5 ->
      f "(maybe %s %s %s)" (e ty) (lambda s fuel other ty)
        (typed (e (Type.maybe other)) (Type.maybe other))
  | 6 ->
      let left = any_type s in
      let sum = Type.either left other in
      f "(either %s %s %s)" (lambda s fuel left ty) (lambda s fuel other ty) (typed (e sum) sum)
  | 7 -> f "(clampTo %s %s %s)" (typed (e ty) ty) (e ty) (e ty)
  | 8 -> f "(twice %s %s)" (lambda s fuel ty ty) (e ty)
  | 9 -> extreme s fuel ty
  | 10 -> (
      match (ty : Type.t) with
      | Float | Int -> f "(oneMore %s)" (e ty)
      | Bool -> f "(firstDiffers %s %s)" (typed (e other) other) (e other)
      | Measure _ | Tuple _ | Array _ | Data _ -> f "(id %s)" (e ty))
  | _ -> f "(id %s)" (e ty)

(* Methods of the classes that all programs share. *)
and overloaded s fuel ty =
  let e ty = typed (expression s fuel ty) ty in
  let rec measured tries =
    let ty = any_type s in
    if Type.has_instances ~measured:true ty then ty
    else if tries = 0 then Type.Float
    else measured (tries - 1)
  in
  match (ty : Type.t) with
  | Float -> f "(size %s)" (e (measured 3))
  | Bool ->
      let other = measured 3 in
      f "(bigger %s %s)" (e other) (e other)
  | _ when Type.has_instances ~measured:false ty && chance s.random 2 -> f "(next %s)" (e ty)
  | _ when Type.has_instances ~measured:true ty -> f "(largest %s %s)" (e ty) (e ty)
  | Measure _ | Int | Tuple _ | Array _ | Data _ -> f "(id %s)" (expression s fuel ty)

(* Functions that may use the values of the instant. *)
and higher_order s fuel ty =
  let argument = any_type s in
  let value s = typed (expression s fuel argument) argument in
  let one () = lambda s fuel argument ty in
  match Random.State.int s.random 6 with
  | 0 -> f "(%s %s)" (one ()) (value s)
  | 4 -> array_of_functions s fuel argument ty
  | 1 ->
      note s "function chosen at run time";
      f "((if %s then %s else %s) %s)" (expression s fuel Bool) (one ()) (one ()) (value s)
  | 2 ->
      let name = fresh s "g" in
      f "(case (if %s then Just %s else Nothing) of Just %s -> %s %s; Nothing -> %s)"
        (expression s fuel Bool) (one ()) name name
        (value (elsewhere s))
        (expression (elsewhere s) fuel ty)
  | 3 -> f "((fst (%s, %s)) %s)" (one ()) (literal s Int) (value s)
  | _ ->
      let middle = any_type s in
      f "((%s . %s) %s)" (lambda s fuel middle ty) (lambda s fuel argument middle) (value s)

(* Functions made at run time, each with its captured values; the result uses some of them. *)
and array_of_functions s fuel argument ty =
  note s "array of functions";
  let n = 1 + Random.State.int s.random 3 in
  let whole = f "(Array %d (%s -> %s))" n (Type.text argument) (Type.text ty) in
  let inside = elsewhere s in
  let number = fresh s "k" in
  let counted = bind [ (number, Type.Int) ] inside in
  let written () = Constant.array (List.init n (fun _ -> function_ s fuel [ argument ] ty)) in
  let rec made tries =
    match Random.State.int s.random (if tries = 0 then 2 else 5) with
    | 0 | 1 -> written ()
    | 2 ->
        let other = any_type s in
        let name = fresh s "e" in
        f "(map (\\%s -> %s) (%s :: Array %d %s))" name
          (function_ (bind [ (name, other) ] inside) fuel [ argument ] ty)
          (expression s fuel (Array (n, other)))
          n (Type.text other)
    | 3 -> f "(if %s then %s else %s)" (expression s fuel Bool) (made 0) (made 0)
    | _ -> f "(generate (\\%s -> %s))" number (function_ counted fuel [ argument ] ty)
  in
  let array = f "(%s :: %s)" (made 1) whole in
  let value s = typed (expression s fuel argument) argument in
  match Random.State.int s.random 3 with
  | 0 -> f "((%s ! %d) %s)" array (Random.State.int s.random n) (value s)
  | 1 ->
      let g = fresh s "g" and last = fresh s "r" in
      f "(foldl (\\%s %s -> choose (%s == %s) (%s %s) %s) %s %s)" last g last last g (value inside)
        last
        (typed (expression s fuel ty) ty)
        array
  | _ -> f "(at %s %s %s %s)" (index s fuel) (function_ s fuel [ argument ] ty) array (value s)

and field s fuel ty =
  let fields_of : Type.t -> _ = function
    | Data ({ constructors = [ c ]; _ } as data) as record when Type.is_record data ->
        List.filter_map (fun (name, t) -> if t = ty then Some (record, name) else None) c.fields
    | Float | Measure _ | Int | Bool | Tuple _ | Array _ | Data _ -> []
  in
  match List.concat_map fields_of s.declared with
  | [] -> by_type s fuel ty
  | fields -> (
      let record, name = one_of s.random fields in
      let value = typed (expression s fuel record) record in
      match record with
      | Data { constructors = [ c ]; _ } when chance s.random 4 ->
          note s "pun in a pattern";
          f "(case %s of %s { %s } -> %s)" value c.name name name
      | _ ->
          note s "record field";
          f "%s.%s" value name)

and call s fuel ty =
  let name, parameters, _ = one_of s.random (functions_to s ty) in
  match parameters with
  | [] -> name
  | _ -> f "(%s)" (String.concat " " (name :: List.map (expression s fuel) parameters))
