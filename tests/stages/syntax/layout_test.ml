(* Tests layout: each case writes the same program in two ways. *)

open Programs

let parsed text =
  match parse text with
  | _, Some program -> program
  | (d : Basis.Diagnostic.t) :: _, None ->
      Alcotest.failf "%s %s at %a in:\n%s" d.code
        (Basis.Diagnostic.for_display d.message)
        Basis.Span.pp d.at text
  | [], None -> Alcotest.fail "rejected without a word"

let same name a b =
  let check () =
    let a = parsed a and b = parsed b in
    if Without_spans.program a <> Without_spans.program b then
      Alcotest.failf "%s\nis not\n%s" (printed a) (printed b)
  in
  Alcotest.test_case name `Quick check

let rejected name code text =
  Alcotest.test_case name `Quick (fun () ->
      Alcotest.(check (list string)) name [ code ] (codes text))

let blocks =
  [
    same "semicolons part items" "x = let a = 1; b = 2 in a" "x = let a = 1\n        b = 2 in a";
    same "empty items" "x = let ;; a = 1 ;; b = 2; in a" "x = let a = 1; b = 2 in a";
    same "`in` closes the innermost let" "x = let a = let b = 1\n        in b\n    in a"
      "x = let a = let b = 1 in b in a";
    same "a parenthesis closes blocks" "x = (case y of A -> 1; B -> 2)"
      "x = (case y of\n  A -> 1\n  B -> 2\n  )";
    same "a comma closes blocks" "x = (case y of A -> 1, 2)"
      "x = (case y of\n      A -> 1\n    , 2)";
    same "a comma in a tuple in a block does not" "x = let a = (1, 2); b = 3 in a"
      "x = let a = (1\n           , 2)\n        b = 3\n    in a";
    same "`then` and `else` close blocks" "x = if case y of A -> b then case y of A -> 1 else 2"
      "x = if case y of\n         A -> b\n    then case y of\n         A -> 1\n    else 2";
    same "`of` closes blocks" "x = case let a = 1 in a of A -> 1"
      "x = case let a = 1 in a of\n  A -> 1";
    same "a line further right goes on" "x = f\n  a\n   b" "x = f a b";
    same "a closing bracket in the first column" "x = f (\n  a, b\n)" "x = f (a, b)";
    same "a record over several lines" "x = R\n  { a = 1\n  , b = 2\n  }" "x = R { a = 1, b = 2 }";
    same "empty let" "x = let in 1" "x = let\n    in 1";
    same "a block no further right is empty" "instance Shape Circle where\nz = 1"
      "instance Shape Circle\n\nz = 1";
    same "a non-ASCII text counts by characters"
      "x = f \"é\" (let a = 1\n               b = 2 in a)" "x = f \"é\" (let a = 1; b = 2 in a)";
    same "a `let` in a `do`" "x = proc y -> do\n  let a = 1\n      b = 2\n  f -< a"
      "x = proc y -> do\n  let a = 1; b = 2\n  f -< a";
  ]

let where =
  [
    same "of a proc" "f = proc x -> y where y = x" "f = proc x -> y\n  where\n    y = x";
    same "at the column of a block's items closes the block"
      "f = proc x -> case x of\n  A -> y\n  where y = 1"
      "f = proc x -> case x of\n    A -> y\n  where y = 1";
    same "of a branch, further right" "f x = case x of\n  A -> y\n    where y = 1\n  B -> 2"
      "f x = case x of\n  A -> y where y = 1\n  B -> 2";
    same "after a do belongs to the definition" "f = proc x -> do\n    g -< x\n  where y = 1"
      "f = proc x -> do\n    g -< x\n    where y = 1";
    same "on the do's last line too" "f = proc x -> do g -< x where y = 1"
      "f = proc x -> do\n    g -< x\n  where y = 1";
    same "after a command belongs to the definition" "f = proc x -> g -< x where y = 1"
      "f = proc x -> g -< x\n  where\n  y = 1";
    same "of the inner proc first" "f = proc x -> proc z -> y where y = 1"
      "f = proc x -> proc z -> y\n  where y = 1";
    same "of a guarded definition" "f x | x = 1\n    | y = 2\n  where y = x"
      "f x\n  | x = 1\n  | y = 2\n where\n  y = x";
    rejected "in the first column" "E0110" "f = x\nwhere x = 1";
  ]

let statements =
  [
    same "the paper's stray semicolon" "f = proc x -> do\n  y <- g -< x;\n  h -< y"
      "f = proc x -> do\n  y <- g -< x\n  h -< y";
    same "`rec` has no effect" "f = proc x -> do\n  rec y <- g -< z\n      z <- h -< y\n  k -< z"
      "f = proc x -> do\n  y <- g -< z\n  z <- h -< y\n  k -< z";
    same "`then` and `else` at the column of the `if`"
      "f = proc x -> do\n  y <- if a\n  then b\n  else c\n  h -< y"
      "f = proc x -> do\n  y <- if a then b else c\n  h -< y";
    same "a dropped output" "f = proc x -> do\n  g -< x\n  h -< x"
      "f = proc x -> do\n  _ <- g -< x\n  h -< x";
    rejected "no output" "E0116" "f = proc x -> do\n  y <- g -< x";
    rejected "a choice of commands" "E0116" "f = proc x -> do\n  if x then g -< x else h -< x";
    rejected "a choice of commands by case" "E0116" "f = proc x -> do\n  case x of\n    A -> g -< x";
  ]

(* Adds all parentheses that the operator table implies, for names and numbers. *)
let rec bracketed (e : Syntax.Ir.expr) =
  match e.desc with
  | Variable x | Constructor x -> x.name.text
  | Number n -> n.digits
  | Binary { operator; left; right } ->
      Printf.sprintf "(%s %s %s)" (bracketed left) operator.name.text (bracketed right)
  | Apply (f, x) -> Printf.sprintf "(%s %s)" (bracketed f) (bracketed x)
  | Negate e -> Printf.sprintf "(-%s)" (bracketed e)
  | Power { base; exponent } -> Printf.sprintf "(%s ^ %d)" (bracketed base) exponent
  | Field { record; field } -> Printf.sprintf "(%s.%s)" (bracketed record) field.text
  | Parenthesized e -> bracketed e
  | Left_section { left; operator } -> Printf.sprintf "[%s %s]" (bracketed left) operator.name.text
  | Right_section { operator; right } ->
      Printf.sprintf "[%s %s]" operator.name.text (bracketed right)
  | String _ | Tuple _ | Tuple_section _ | Lambda_case _ | Array _ | If _ | Case _ | Let _
  | Lambda _ | Proc _ | Sequence _ | Record _ | Update _ | Annotated _ ->
      Alcotest.fail "not in these tests"

let groups text expected =
  let check () =
    match parsed ("x = " ^ text) with
    | { declarations = [ { desc = Binding { right = { body = Plain e; _ }; _ }; _ } ]; _ } ->
        Alcotest.(check string) text expected (bracketed e)
    | _ -> Alcotest.fail "one definition was expected"
  in
  Alcotest.test_case text `Quick check

let operators =
  [
    groups "f a * g b" "((f a) * (g b))";
    groups "a - b - c" "((a - b) - c)";
    groups "a / b * c" "((a / b) * c)";
    groups "a ** b ** c" "(a ** (b ** c))";
    groups "a + b ^ 2 * c" "(a + ((b ^ 2) * c))";
    groups "-a + b" "((-a) + b)";
    groups "-a * b" "(-(a * b))";
    groups "-a ^ 2" "(-(a ^ 2))";
    groups "a == -b" "(a == (-b))";
    groups "a < b && c || d" "(((a < b) && c) || d)";
    groups "a && b && c" "(a && (b && c))";
    groups "a `mod` b + c `max` d" "((a mod b) + (c max d))";
    groups "a `mod` b `f` c" "(a mod (b f c))";
    groups "f . g . h" "(f . (g . h))";
    groups "f . g $ a + b" "((f . g) (a + b))";
    groups "f $ g $ a" "(f (g a))";
    groups "f >>> g &&& h" "(f >>> (g &&& h))";
    groups "f p.a.b c" "((f ((p.a).b)) c)";
    groups "p.a . q.b" "((p.a) . (q.b))";
    groups "(a + b) * c" "((a + b) * c)";
    groups "(a * b +)" "[(a * b) +]";
    groups "(+ a * b)" "[+ (a * b)]";
    groups "(. f . g)" "[. (f . g)]";
    groups "(subtract -)" "[subtract -]";
    groups "(- a)" "(-a)";
    groups "a ^ (-2)" "(a ^ -2)";
    groups "a *^ b ^+^ c" "((a *^ b) ^+^ c)";
    same "`$` of an atom" "x = f $ a" "x = f a";
    same "a unit follows its number" "x = 2[m / s]" "x = 2[m/s]";
    same "exponents of units" "x = 2[m s^-1]" "x = 2[m s^(-1)]";
    same "quotients of powers" "x = 2[m^(2/4)]" "x = 2[m^(1/2)]";
    rejected "comparisons do not chain" "E0113" "x = a < b < c";
    rejected "minus after times" "E0113" "x = a * -b";
    rejected "a section that takes a part" "E0113" "x = (a + b *)";
    rejected "an exponent that is no literal" "E0117" "x = a ^ b";
  ]

let () =
  Alcotest.run "layout and grammar"
    [ ("blocks", blocks); ("where", where); ("statements", statements); ("operators", operators) ]
