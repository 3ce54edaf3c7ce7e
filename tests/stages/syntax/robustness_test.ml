(* Checks that the parser returns a result or a message in a short time for any bytes. *)

open Programs

let codes_are name text expected () =
  Alcotest.(check (list string)) name expected (List.sort_uniq String.compare (codes text))

let repeat n text =
  let all = Buffer.create (n * String.length text) in
  for _ = 1 to n do
    Buffer.add_string all text
  done;
  Buffer.contents all

let case name text expected = Alcotest.test_case name `Quick (codes_are name text expected)

let deep =
  [
    case "parentheses within the limit"
      ("x = " ^ String.make 9_000 '(' ^ "1" ^ String.make 9_000 ')')
      [];
    case "parentheses beyond it"
      ("x = " ^ String.make 100_000 '(' ^ "1" ^ String.make 100_000 ')')
      [ "E0106" ];
    case "unclosed parentheses" ("x = " ^ String.make 9_000 '(') [ "E0111" ];
    case "functions" ("x = " ^ repeat 9_000 "\\y -> " ^ "1") [];
    case "functions beyond the limit" ("x = " ^ repeat 100_000 "\\y -> " ^ "1") [ "E0106" ];
    case "operators" ("x = " ^ repeat 9_000 "a + " ^ "1") [];
    case "operators beyond the limit" ("x = " ^ repeat 200_000 "a + " ^ "1") [ "E0106" ];
    case "minus signs" ("x = " ^ repeat 100_000 "- " ^ "1") [ "E0113" ];
    case "arrows beyond the limit" ("x :: " ^ repeat 100_000 "a -> " ^ "a") [ "E0106" ];
    case "arguments beyond the limit" ("x = f" ^ repeat 100_000 " a") [ "E0106" ];
    case "units beyond the limit" ("x = 1[m" ^ repeat 100_000 " m" ^ "]") [ "E0106" ];
    case "blocks" ("x = " ^ repeat 100_000 "let a = " ^ "1") [ "E0106" ];
    case "conditions" ("x = " ^ repeat 100_000 "if a then " ^ "1") [ "E0106" ];
    case "openers and then commas" ("x = " ^ repeat 9_000 "if " ^ repeat 500_000 ",") [ "E0110" ];
    case "comments" (repeat 500_000 "{-" ^ repeat 500_000 "-}" ^ "\nx = 1") [];
    case "an open comment" (repeat 500_000 "{-") [ "E0104" ];
    case "as-patterns" ("f " ^ repeat 100_000 "x@" ^ "y = 1") [ "E0110" ];
  ]

let big =
  let million = 1_000_000 in
  [
    case "an empty file" "" [];
    case "only blanks and comments" "  \n -- nothing\n\n" [];
    case "a byte order mark" "\xef\xbb\xbfx = 1\n" [];
    case "carriage returns" "-- | doc\r\nx = 1\r\ny =\r\n  2\r\n" [];
    case "no last line end" "x = 1" [];
    case "many definitions"
      (String.concat "" (List.init 50_000 (Printf.sprintf "x%d = f (1 + 2)\n")))
      [];
    case "a wide tuple" ("x = (1" ^ repeat 200_000 ", 1" ^ ")") [];
    case "many fields" ("data T = T { a" ^ repeat 200_000 ", a" ^ " :: Int }") [];
    case "many names" (repeat 200_000 "a, " ^ "a :: Int") [];
    case "a name of a thousand letters" (String.make 1_000 'x' ^ " = 1") [];
    case "a long name" (String.make million 'x' ^ " = 1") [ "E0105" ];
    case "a number of a thousand digits" ("x = " ^ String.make 1_000 '9') [];
    case "a long number" ("x = " ^ String.make million '9') [ "E0105" ];
    case "a comment never closed is one mistake" "x = (1 + {- 2)" [ "E0104" ];
    case "a long text" ("x = \"" ^ String.make million 'a' ^ "\"") [];
    case "lines without meaning" (repeat million ")\n") [ "E0111" ];
    case "control characters" (repeat million "\001\n") [ "E0103" ];
    case "zero bytes" (String.make million '\000') [ "E0103" ];
    case "no UTF-8" (String.make million '\255') [ "E0101" ];
    case "an overlong form" "-- \xc0\x80\n" [ "E0101" ];
    case "half a character at the end" "-- \xe2\x82" [ "E0101" ];
    case "tabs, told once" ("x = 1\n" ^ repeat 1000 "\ty\n") [ "E0102" ];
  ]

let never_raises name count generator =
  let test =
    QCheck.Test.make ~name ~count (QCheck.make ~print:String.escaped generator) (fun text ->
        ignore (parse text);
        true)
  in
  Alcotest.test_case name `Quick (fun () ->
      QCheck.Test.check_exn ~rand:(Random.State.make [| 4 |]) test)

let pieces =
  [|
    "let";
    "in";
    "where";
    "do";
    "of";
    "case";
    "if";
    "then";
    "else";
    "proc";
    "rec";
    "module";
    "import";
    "qualified";
    "as";
    "data";
    "type";
    "unit";
    "primitive";
    "class";
    "x";
    "y'";
    "M.x";
    "M.N";
    "T";
    ".f";
    ".";
    "1";
    "1.5";
    "2[m]";
    "[";
    "]";
    "(";
    ")";
    "{";
    "}";
    ",";
    ";";
    "`";
    "@";
    "\\";
    "=";
    "|";
    "->";
    "<-";
    "-<";
    "=>";
    "::";
    "-";
    "+";
    "*";
    "/";
    "^";
    "$";
    "<";
    "==";
    "_";
    "\"s\"";
    "-- | d\n";
    "{-";
    "-}";
    "\n";
    "\n";
    "\n  ";
    "\n  ";
    "\n    ";
    "\n ";
    "'";
    "\t";
    "pi";
  |]

let tokens = QCheck.Gen.(map (String.concat " ") (list_size (int_bound 60) (oneofa pieces)))
let bytes = QCheck.Gen.(string_size ~gen:char (int_bound 200))
let ascii = QCheck.Gen.(string_size ~gen:(char_range ' ' '~') (int_bound 200))

let () =
  Alcotest.run "robustness"
    [
      ("deep", deep);
      ("big and odd", big);
      ( "random",
        [
          never_raises "tokens" 20_000 tokens;
          never_raises "characters" 5_000 ascii;
          never_raises "bytes" 5_000 bytes;
        ] );
    ]
