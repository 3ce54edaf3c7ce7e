(* Tests the meaning of names, one behaviour at a time: each test is a program and the expected
   diagnostic codes. *)

let check point files expected =
  Alcotest.test_case point `Quick (fun () ->
      let diagnostics, _ = Support.load files in
      Alcotest.(check (list string)) point expected (Support.codes diagnostics))

let one point text expected = check point [ ("main.frob", text) ] expected

let gains =
  ("Gains.frob", "module Gains (gain, Side) where\ngain = 2.0\nsecret = 1.0\ndata Side = L | R\n")

let scoping =
  [
    one "locals hide imported names silently" "f sin = sin + 1\n" [];
    one "own definitions hide the prelude's" "pi = 3\nf = pi\n" [];
    one "a where sees the parameters and all guards see it"
      "f x | big = 1 | otherwise = x where big = x > 1\n" [];
    one "equations of a proc see each other in any order"
      "f = proc x -> z where z = y + 1; y = delay 0 x\n" [];
    one "statements of a proc see later ones"
      "f = proc v -> do r <- delay 0 -< r + v; returnA -< r\n" [];
    one "rec has no effect"
      "f = proc v -> do\n  rec r <- delay 0 -< q\n      q <- v + r\n  returnA -< r\n" [];
    one "a definition's where does not see a proc's variables"
      "f = proc v -> do\n    returnA -< y\n  where\n    y = v\n" [ "E0205" ];
    one "a branch's variables end with it" "f m = case m of Just x -> x; Nothing -> x\n" [ "E0205" ];
    one "hiding a local is a warning" "f x = (\\x -> x) x\n" [ "W0201" ];
    one "an equation may not rebind one of its group"
      "f = proc x -> y where y = x; (y, z) = (x, x)\n" [ "E0212" ];
    one "parameters are one group" "f x x = x\n" [ "E0212" ];
    one "statements are one group"
      "f = proc x -> do y <- identity -< x; y <- identity -< y; returnA -< y\n" [ "E0212" ];
    one "signatures of destructured variables in a where"
      "f x = a where a, b :: Float; (a, b) = (x, 2)\n" [];
  ]

let importing =
  [
    check "a module beside the program" [ ("main.frob", "import Gains\nf = gain\n"); gains ] [];
    check "what a header does not list stays inside"
      [ ("main.frob", "import Gains\nf = secret\n"); gains ]
      [ "E0205" ];
    check "a type in a list brings its constructors"
      [ ("main.frob", "import Gains (Side)\nf = L\n"); gains ]
      [];
    check "what an import does not list is not seen"
      [ ("main.frob", "import Gains (Side)\nf = gain\n"); gains ]
      [ "E0205" ];
    check "qualified imports are seen only qualified"
      [ ("main.frob", "import qualified Gains as G\nf = G.gain\ng = gain\n"); gains ]
      [ "E0205" ];
    check "an alias replaces the module's name"
      [ ("main.frob", "import Gains as G\nf = G.gain + gain\ng = Gains.gain\n"); gains ]
      [ "E0215" ];
    check "the prelude may be named" [ ("main.frob", "f = Prelude.pi\n") ] [];
    check "two imports of one name clash where it is used"
      [
        ("main.frob", "import Gains\nimport Other\nf = gain\n"); gains; ("Other.frob", "gain = 3\n");
      ]
      [ "E0210" ];
    check "two imports of one name do not clash unused"
      [ ("main.frob", "import Gains\nimport Other\n"); gains; ("Other.frob", "gain = 3\n") ]
      [];
    check "one thing by two ways is no clash"
      [
        ("main.frob", "import Gains\nimport Other\nf = gain\n");
        gains;
        ("Other.frob", "module Other (gain) where\nimport Gains\n");
      ]
      [];
    check "a name that an import clashes with the prelude on"
      [ ("main.frob", "import Other\nf = pi\n"); ("Other.frob", "pi = 3\n") ]
      [ "E0210" ];
    check "a module beside the program hides the library's"
      [ ("main.frob", "import Geometry\nf = gain\n"); ("Geometry.frob", "gain = 3\n") ]
      [];
    check "two modules of one name in a program"
      [ ("main.frob", "import Geometry\nimport Robot\n"); ("Geometry.frob", "gain = 3\n") ]
      [ "E0203" ];
    check "names of a missing module are not reported again"
      [ ("main.frob", "import Gians\nf = gain\n") ]
      [ "E0201" ];
    check "an import cycle"
      [ ("main.frob", "import A\n"); ("A.frob", "import B\n"); ("B.frob", "import A\n") ]
      [ "E0202" ];
    check "a file whose header says another name"
      [ ("main.frob", "import A\n"); ("A.frob", "module B where\n") ]
      [ "E0203" ];
    check "errors of all modules in one run"
      [ ("main.frob", "import A\nf = nowhere\n"); ("A.frob", "g = nothing\n") ]
      [ "E0205"; "E0205" ];
    check "a missing program" [] [ "E0201" ];
  ]

let types =
  [
    one "a single small letter is a unit variable"
      "f :: Float[u] -> Float[u1] -> Float[v']\nf x y = 0\n" [];
    one "other unknown units are errors" "f :: Float[uv] -> Float\nf x = 0\n" [ "E0208" ];
    one "a program's units are seen in its types" "unit tick\nf :: Int[tick]\nf = 3[tick]\n" [];
    one "units of types need their number" "f :: Float[m, s]\nf = 0\n" [ "E0216" ];
    one "a builtin type with too many arguments" "f :: Bool Int\nf = True\n" [ "E0216" ];
    one "aliases in a circle" "type A = B\ntype B = (A, Int)\n" [ "E0217" ];
    one "data in a circle through an alias" "data A = A B\ntype B = Maybe A\n" [ "E0218" ];
    one "records match by some of their fields"
      "import Geometry\nf p = case p of Pose { heading = h } -> h\n" [];
    one "a record pattern with a field it has not"
      "import Geometry\nf p = case p of Pose { headng = h } -> h\n" [ "E0209" ];
  ]

let hint point text expected =
  Alcotest.test_case point `Quick (fun () ->
      match Support.load [ ("main.frob", text) ] with
      | [ d ], _ ->
          let hints = List.map (fun (h : Basis.Diagnostic.hint) -> h.text) d.hints in
          Alcotest.(check (list string))
            point expected
            (List.map Basis.Diagnostic.for_display (hints @ d.notes))
      | diagnostics, _ -> Alcotest.failf "%d diagnostics" (List.length diagnostics))

let hints =
  [
    hint "a misspelt local" "f speed = sped\n" [ "did you mean `speed`?" ];
    hint "a misspelt unit" "f = 3[kmm]\n" [ "did you mean `km`?" ];
    hint "a misspelt module" "import Robt\n"
      [
        "did you mean `Robot`?";
        "frobc looked for `Robt.frob` in the folder of this file and in the library";
      ];
    hint "a library module that is not imported" "f = wrapAngle 3\n"
      [ "`wrapAngle` is in the library: `import Geometry`" ];
    hint "a field used as a function" "data P = P { heading :: Float }\nf p = heading p\n"
      [ "write `p.heading`, or `\\r -> r.heading` if you need a function" ];
    hint "a type used as a constructor" "f = Velocity\n"
      [ "`Velocity` is a type, not a constructor" ];
  ]

(* Compares the binding groups of a program's top level, as names. *)
let groups point text expected =
  Alcotest.test_case point `Quick (fun () ->
      match Support.load [ ("main.frob", text) ] with
      | _, None -> Alcotest.fail "rejected"
      | _, Some program ->
          let names (g : Resolve.Ir.binding_group) =
            List.filter_map
              (fun (b : Resolve.Ir.binding) ->
                match b.name with
                | Top ({ module_ = "Main"; name }, _) -> Some name
                | Top _ | Inner _ | Destructure _ -> None)
              g.bindings
          in
          let all = List.filter (fun g -> g <> []) (List.map names program.groups) in
          Alcotest.(check (list (list string))) point expected all)

let dependencies =
  [
    groups "used before users" "a = b\nb = c\nc = 1\n" [ [ "c" ]; [ "b" ]; [ "a" ] ];
    groups "mutual recursion is one group" "a = b\nb = a\nc = a\n" [ [ "a"; "b" ]; [ "c" ] ];
    groups "a signature parts a group" "a = b\nb :: Float\nb = a\n" [ [ "a" ]; [ "b" ] ];
    groups "a reference from within an inner where counts" "a = x where x = let y = b in y\nb = 1\n"
      [ [ "b" ]; [ "a" ] ];
  ]

let repeated n s = String.concat "" (List.init n (fun _ -> s))

let large =
  [
    one "4,000 nested brackets"
      ("f = " ^ repeated 4_000 "(1 + " ^ "1" ^ repeated 4_000 ")" ^ "\n")
      [];
    one "9,000 nested functions"
      ("f = " ^ String.concat "" (List.init 9_000 (Printf.sprintf "\\x%d -> ")) ^ "1\n")
      [];
    one "a chain of operators without end" ("f = 1" ^ repeated 50_000 " + 1" ^ "\n") [ "E0106" ];
    one "a long list of definitions"
      (String.concat "" (List.init 20_000 (fun i -> Printf.sprintf "x%d = x%d\n" i (i + 1)))
      ^ "x20000 = 1\n")
      [];
    one "a tuple with 100,000 elements" ("f = (1" ^ repeated 100_000 ", 1" ^ ")\n") [];
  ]

let () =
  Alcotest.run "names"
    [
      ("scoping", scoping);
      ("importing", importing);
      ("types", types);
      ("hints", hints);
      ("dependencies", dependencies);
      ("large", large);
    ]
