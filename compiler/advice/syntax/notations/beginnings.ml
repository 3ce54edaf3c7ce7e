open Syntax_topic

let by_equation =
  suggestion Function_by_equation
    "define a function by an equation, `f x = …`; a block ends where its indentation ends"

let no_end = suggestion End_of_block "remove this line: a block ends where its indentation ends"

let no_procedures =
  suggestion No_procedures
    "Frob has no procedures: write equations that hold at every instant, as in `main = \
     reactimateRobot (proc i -> roMake (setVelTR v omega))`"

let declare_a_record declaration =
  suggestion (Record_declaration declaration)
    (Printf.sprintf "declare a record with `data` and a constructor: `%s`" declaration)

let fixes =
  [
    ([ "end"; "endif"; "endfunction"; "fi"; "done" ], no_end);
    ( [ "while" ],
      text
        "to repeat a task, write `forever t`; to repeat it while a signal function returns True, \
         write `whileT condition t`" );
    ( [ "print"; "println"; "printf"; "disp"; "fprintf"; "Serial"; "cout"; "puts" ],
      text
        "a program cannot print, so remove this line: `frobc run FILE --view` shows every signal, \
         `--probe v --record run.csv` records the signal `v`, and the result of a task is printed \
         when the task ends" );
    ([ "struct"; "typedef" ], declare_a_record "data Config = Config { speed :: Velocity }");
    ([ "enum" ], text "declare an enumeration with `data`: `data Side = LeftSide | RightSide`");
    ( [ "extern" ],
      text
        "declare a C function with its Frob type and its C name: `foreign cubeRoot :: Float -> \
         Float = \"cbrt\"`" );
    ([ "pass"; "break"; "continue" ], text "remove this line: Frob has no loops");
    ( [ "global"; "nonlocal" ],
      text "remove this line: an equation can use any name in the module without declaring it" );
    ([ "using"; "namespace" ], text "import names from a module, as in `import Control`");
  ]

let of_word word = Option.map snd (List.find_opt (fun (words, _) -> List.mem word words) fixes)

let is_forever line =
  let blank = function '(' | ')' | ':' | '{' -> ' ' | c -> c in
  let words = List.filter (( <> ) "") (String.split_on_char ' ' (String.map blank line)) in
  match words with
  | [ "while"; ("True" | "true" | "1") ] | [ "while"; ("True" | "true" | "1"); "do" ] | [ "loop" ]
    ->
      true
  | _ -> false

let forever = "to repeat the tasks of this block, write `forever $ do` in place of this line"

(* The number of iterations in `for i in range(4)`, `for i in 1..4` or `for (i = 0; i < 4; i++)`. *)
let rounds line =
  let is_for =
    List.exists (fun w -> String.starts_with ~prefix:w (String.trim line)) [ "for "; "for(" ]
  in
  let separate c = if Basis.Character.is_digit c then c else ' ' in
  let numbers = List.filter (( <> ) "") (String.split_on_char ' ' (String.map separate line)) in
  let is_counted =
    String.contains line '.' || String.contains line '(' || String.contains line ':'
    || List.mem "to" (String.split_on_char ' ' line)
  in
  match List.rev numbers with last :: _ when is_for && is_counted -> Some last | _ -> None

let repeated rounds =
  Printf.sprintf
    "to run the tasks of this block %s times, write `repeatT %s $ do` in place of this line" rounds
    rounds

(* The numbers in a range such as `1..10`, if there are at most 12. *)
let range text =
  let digits = String.for_all Basis.Character.is_digit in
  match String.split_on_char '.' text with
  | [ first; ""; last ] when first <> "" && last <> "" && digits first && digits last -> (
      match (int_of_string_opt first, int_of_string_opt last) with
      | Some a, Some b when a <= b && b - a < 12 ->
          Some (List.init (b - a + 1) (fun i -> string_of_int (a + i)))
      | _ -> None)
  | _ -> None

let no_ranges inside =
  match range inside with
  | Some numbers ->
      Printf.sprintf "Frob has no ranges: write the elements, `[%s]`" (String.concat ", " numbers)
  | None ->
      "Frob has no ranges: write the elements, as in `[1, 2, 3]`, or compute each from its index, \
       as in `generate (\\i -> i + 1)`; the type of the array determines its size"

let waiting =
  suggestion Waiting
    "to wait in a task, write `sleepT 1[s] restingOutput`; in a `proc`, `after 1[s] ()` is an \
     event that occurs 1 s after the start"

let waits word =
  List.mem word [ "delay"; "delayMicroseconds"; "sleep"; "usleep"; "wait"; "pause"; "sleepT" ]

let needless =
  [ "const"; "constexpr"; "var"; "val"; "auto"; "static"; "final"; "local"; "global"; "def"; "let" ]
