(* Small definitions, and the principal types that inference must find for them. *)

open Basis

let library = "../../../stdlib"

let read path =
  match Resolve.Files.on_disk.read path with
  | Ok text -> text
  | Error _ -> failwith ("cannot read " ^ path)

let library_texts =
  lazy
    (List.map
       (fun name -> ("stdlib/" ^ name ^ ".frob", read (Filename.concat library (name ^ ".frob"))))
       (Resolve.Files.on_disk.modules_in library))

(* The types of a module's definitions, or the codes of its errors. *)
let infer text =
  let sink = Diagnostic.sink () in
  let files = Resolve.Files.in_memory (("main.frob", text) :: Lazy.force library_texts) in
  let remember ~file:_ _ = () in
  let typed =
    Option.map
      (Typing.Infer.program (Advice.Of_typing.into sink) ~real:Double)
      (Resolve.Program.load (Advice.Of_resolve.into sink) ~files ~remember ~library:"stdlib"
         "main.frob")
  in
  match typed with
  | Some typed when not (Diagnostic.has_errors sink) ->
      Typing.Lint.program typed;
      List.filter_map
        (fun (d : Typing.Ir.definition) ->
          if String.equal d.name.module_ typed.main_module then
            Some (d.name.name ^ " :: " ^ Typing.Show.scheme d.scheme)
          else None)
        typed.definitions
  | Some _ | None -> List.map (fun (d : Diagnostic.t) -> d.code) (Diagnostic.all sink)

let case (point, text, expected) =
  Alcotest.test_case point `Quick (fun () ->
      Alcotest.(check (list string)) text expected (infer text))

let functions =
  [
    ("a variable is anything", "f x = x", [ "f :: a -> a" ]);
    ("tuples", "f (x, y) = (y, x, ())", [ "f :: (a, b) -> (b, a, ())" ]);
    ("composition", "f g h x = g (h x)", [ "f :: (a -> b) -> (c -> a) -> c -> b" ]);
    ("top-level values generalize", "n = Nothing\nf = id", [ "n :: Maybe a"; "f :: a -> a" ]);
    ( "a recursive group is generalized as a whole",
      "f x = if x then True else g x\ng y = f y",
      [ "f :: Bool -> Bool"; "g :: Bool -> Bool" ] );
    ( "a local function with a signature is polymorphic",
      "f x = (same 1.0, same x) where\n  same :: a -> a\n  same y = y",
      [ "f :: a -> (Float, a)" ] );
    ( "a local function without a signature is not",
      "f x = (same 1.0, same True) where same y = y",
      [ "E0301" ] );
    ( "variables of a signature are in scope in the body",
      "f :: a -> (a, a)\nf x = (y, x) where\n  y :: a\n  y = x",
      [ "f :: a -> (a, a)" ] );
    ( "a local signature cannot claim an outer variable's type",
      "f x = g x where\n  g :: a -> a\n  g y = if True then y else x",
      [ "E0306" ] );
    ("annotations", "f x = (x :: Distance)", [ "f :: Float[m] -> Float[m]" ]);
  ]

let signal_functions =
  [
    ("juxtaposition runs", "f = proc x -> integral x", [ "f :: SF Float[u] Float[u s]" ]);
    ("juxtaposition applies a function", "f = proc x -> sin x", [ "f :: SF Float Float" ]);
    ("an unknown head is a function", "f h x = h (h x)", [ "f :: (a -> a) -> a -> a" ]);
    ( "a head is known by the end of the group",
      "f = proc x -> g (x, derivative) where g (y, h) = h y + derivative x",
      [ "f :: SF Float[u] Float[u/s]" ] );
    ( "a head is known from its signature",
      "f :: SF a b -> SF a b\nf h = proc x -> h x",
      [ "f :: SF a b -> SF a b" ] );
    ("a command runs whatever its head is", "f h = proc x -> h -< x", [ "f :: SF a b -> SF a b" ]);
    ( "the paper's integral",
      "i = proc (v, t) -> do\n\
      \  t' <- delay 0 -< t\n\
      \  r <- delay 0 -< r + (t - t') * v\n\
      \  returnA -< r",
      [ "i :: SF (n[u], n[v]) n[u v]" ] );
    ( "mutually recursive equations",
      "f = proc x -> y where\n  y = delay 0 z\n  z = x + y",
      [ "f :: SF n[u] n[u]" ] );
    ("signals that are ignored", "f = proc _ -> time ()", [ "f :: SF a Float[s]" ]);
  ]

let units =
  [
    ("multiplication adds exponents", "f x = x * x", [ "f :: n[u] -> n[u^2]" ]);
    ("division subtracts them", "f x y = x / y", [ "f :: Float[u] -> Float[v] -> Float[u/v]" ]);
    ("roots halve them", "f x = sqrt x", [ "f :: Float[u] -> Float[u^(1/2)]" ]);
    ("powers multiply them", "f x = x ^ 3 + 1[m^6]", [ "f :: n[m^2] -> n[m^6]" ]);
    ("a unit is solved for", "f x = 3.0[m] / x + 1[m/s]", [ "f :: Float[s] -> Float[m/s]" ]);
    ( "variables are as few as can be",
      "f x y = (x * y, sqrt (x * y))",
      [ "f :: Float[u] -> Float[v] -> (Float[u v], Float[u^(1/2) v^(1/2)])" ] );
    ( "base units stay out of variables",
      "f x = (x * 1.0[m], x * 1.0[s])",
      [ "f :: Float[u] -> (Float[u m], Float[u s])" ] );
    ("comparison needs equal units", "f x = x < 2[kg]", [ "f :: n[kg] -> Bool" ]);
    ("zero has every unit", "f x = max 0 x", [ "f :: n[u] -> n[u]" ]);
    ("a derived unit is its base units", "f = 2.0[N]", [ "f :: Float[kg m/s^2]" ]);
    ("angles have none", "f = 30[deg]", [ "f :: Float" ]);
    ("nothing decides a local unit", "f = if 0 < 0 then 1 else 2", [ "f :: n[1]" ]);
    ( "data with units",
      "import Geometry\nf v = v.x * 2.0[s] where\n  w = dot v (Vec2 { x = 1.0[m], y = 0 })",
      [ "f :: Vec2[u] -> Float[u s]" ] );
  ]

let numbers =
  [
    ("a plain literal fits both", "f x = x + 1", [ "f :: n[1] -> n[1]" ]);
    ("a point makes a Float", "f x = x + 1.0", [ "f :: Float -> Float" ]);
    ("a scaled unit makes a Float", "f = 5[mm]", [ "f :: Float[m]" ]);
    ("a unit alone does not", "f = 5[m]", [ "f :: n[m]" ]);
    ("the least Int", "f :: Int\nf = -2147483648", [ "f :: Int" ]);
    ("one less is out of range", "f :: Int\nf = -2147483649", [ "E0313" ]);
    ("a large literal is a Float", "f = 3000000000", [ "f :: Float" ]);
    ("a negative power is of a Float", "f x = x ^ (-1)", [ "f :: Float[u] -> Float[1/u]" ]);
    ("Int and Float do not mix", "f = toFloat 1 + round 2.0", [ "E0312" ]);
  ]

let classes =
  [
    ("equality is inferred", "f x y = x == y", [ "f :: Eq a => a -> a -> Bool" ]);
    ("an order includes equality", "f x y = x == y || x < y", [ "f :: Ord a => a -> a -> Bool" ]);
    ( "classes of parts",
      "f x y = (x, 1.0) == (Just y, 2.0)",
      [ "f :: Eq a => Maybe a -> a -> Bool" ] );
    ( "an Ord in the context gives Eq",
      "f :: Ord a => a -> a -> Bool\nf x y = x == y",
      [ "f :: Ord a => a -> a -> Bool" ] );
    ("functions have none", "f = Just sin == Nothing", [ "E0307" ]);
    ( "only the parameters that are compared",
      "data P a = P Bool\nf :: P a -> P a -> Bool\nf x y = x == y",
      [ "f :: P a -> P a -> Bool" ] );
  ]

let records =
  [
    ( "a field by its record's type",
      "import Geometry\nf :: Pose -> Distance\nf p = p.position.x",
      [ "f :: Pose -> Float[m]" ] );
    ("the only type with the field", "import Geometry\nf p = p.heading", [ "f :: Pose -> Float" ]);
    ( "a type that comes later decides",
      "data A = A { k :: Bool }\ndata B = B { k :: Int }\nf x = (x.k, g x)\ng :: B -> B\ng y = y",
      [ "g :: B -> B"; "f :: B -> (Int, B)" ] );
    ( "several types and nothing to tell",
      "data A = A { k :: Bool }\ndata B = B { k :: Int }\nf x = x.k",
      [ "E0311" ] );
    ( "an update keeps the type",
      "import Geometry\nf p h = p { heading = h }",
      [ "f :: Pose -> Float -> Pose" ] );
  ]

let mistakes =
  [
    ( "one mistake, one message, also for its users",
      "f = 1[m] + 1[s]\ng = f + 2[kg]\nh = f && True",
      [ "E0320" ] );
    ("two mistakes, two messages", "f = 1[m] + 1[s]\ng = not 3", [ "E0320"; "E0301" ]);
    ("a comparison in error needs no class", "f = proc () -> time > 10[s]", [ "E0303" ]);
    ("a function given itself", "f g = g g", [ "E0305" ]);
  ]

let () =
  let suite name cases = (name, List.map case cases) in
  Alcotest.run "Typing.Infer"
    [
      suite "functions" functions;
      suite "signal functions" signal_functions;
      suite "units" units;
      suite "numbers" numbers;
      suite "classes" classes;
      suite "records" records;
      suite "mistakes" mistakes;
    ]
