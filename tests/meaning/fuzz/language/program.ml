open Choice

let f = Printf.sprintf

let input_type : Type.t =
  Tuple
    [
      Float;
      Int;
      Bool;
      Type.event Float;
      Type.maybe (Tuple [ Int; Bool ]);
      Float;
      Array (3, Float);
      Measure { metres = 1; seconds = 0 };
    ]

let scope ?(params = []) ~seen ~seed ~random ~prefix ~declared number =
  {
    Scope.random;
    bias = Bias.of_program ~seed number;
    methods = false;
    prefix;
    count = ref 0;
    seen;
    declared;
    variables = params;
    functions = [];
    run = None;
    senses = None;
  }

let large ~seen ~seed ~random ~prefix ~params ~(bias : Bias.t) number =
  let out = Buffer.create 4096 in
  let declared =
    List.fold_left
      (fun declared letter ->
        let ty = Type.declare random ~declared (f "P%d%c" number letter) in
        Buffer.add_string out (Type.declaration ty ^ "\n");
        ty :: declared)
      []
      (if chance random 2 then [ 'A'; 'B' ] else [ 'A' ])
  in
  let values = scope ~seen ~seed ~random ~prefix ~params ~declared number in
  let any () = Scope.any_type values in
  let add (text, s) =
    Buffer.add_string out text;
    s
  in
  let parameter () : Signal_function.parameter =
    match Random.State.int random 3 with
    | 0 -> Value (any ())
    | 1 -> Function (any (), any ())
    | _ -> Signal_function (any (), any ())
  in
  let rec functions k s =
    if k = 0 then s else functions (k - 1) (add (Definition.function_ s (Scope.fresh values "f")))
  in
  let rec signal_functions k s =
    if k = 0 then s
    else
      let parameters = List.init (Random.State.int random 3) (fun _ -> parameter ()) in
      let name = Scope.fresh values "s" in
      signal_functions (k - 1)
        (add
           (Definition.signal_function s ~parameters ~input:(any ())
              ~signals:(Signal_function.any_signals s)
              ~result:(Computed (any ()))
              name))
  in
  let s = { Signal_function.values; known = [] } in
  List.iter (fun ty -> Buffer.add_string out (Definition.instances s ty)) (List.rev declared);
  let s =
    functions (Random.State.int random 3) { s with values = { values with methods = true } }
  in
  let s = if chance random 16 then add (Definition.wide s) else s in
  let s = signal_functions (Random.State.int random 3) s in
  let s =
    if chance random (if bias.switches > 5 then 1 else 2) then add (Definition.modes s) else s
  in
  let s = if chance random (if bias.tasks > 1 then 2 else 5) then add (Definition.tasks s) else s in
  let signals = Signal_function.any_signals s in
  ignore
    (add
       (Definition.signal_function s ~parameters:[] ~input:input_type ~signals ~result:All_signals
          prefix));
  (prefix, Buffer.contents out, signals)

let signature name output = f "%s :: SF %s %s\n" name (Type.text input_type) (Type.text output)

let small values prefix =
  let text, signals = Small_root.make values ~pattern:(Pattern.any values input_type) in
  (prefix, f "%s%s = %s\n\n" (signature prefix (Tuple signals)) prefix text, signals)

let cascades values prefix =
  let pattern = Pattern.any values input_type in
  let text, machines = Cascade.definitions values ~input:input_type ~pattern in
  let signals = List.map (fun _ -> Type.Int) machines in
  let outputs = String.concat ", " (List.map (fun machine -> machine ^ " i") machines) in
  ( prefix,
    f "%s%s%s = proc i -> (%s)\n\n" text (signature prefix (Tuple signals)) prefix outputs,
    signals )

let handing_on values prefix =
  let pattern = Pattern.any values input_type in
  let text, start = Handed_on.definitions values ~input:input_type ~pattern in
  ( prefix,
    f "%s%s%s = proc i -> (%s i)\n\n" text (signature prefix Float) prefix start,
    [ Type.Float ] )

let errand values prefix =
  let text, start = Errand.definitions values ~input:input_type in
  let signals = [ Type.either Float Float ] in
  ( prefix,
    f "%s%s%s = proc i -> (%s i)\n\n" text (signature prefix (Tuple signals)) prefix start,
    signals )

(* The parameters of a program that is compiled alone; programs of a batch have none. *)
let params ~seed ~prefix number : (string * Type.t) list * string =
  let random = Random.State.make [| seed; number; 3 |] in
  let one k : (string * Type.t) * string =
    let ty, value =
      match Random.State.int random 4 with
      | 0 -> (Type.Int, one_of random [ "2"; "-3"; "max 1 0" ])
      | 1 -> (Bool, one_of random [ "True"; "False"; "1.0 < sqrt 2.0" ])
      | 2 -> (Measure { metres = 1; seconds = 0 }, one_of random [ "0.5[m]"; "-20[cm]" ])
      | _ -> (Float, one_of random [ "1.5"; "-0.0"; "sin 30[deg]"; "1 / 3"; "1.0 / 0.0" ])
    in
    let name = f "%sparam%d" prefix k in
    ((name, ty), f "param %s :: %s = %s\n" name (Type.text ty) value)
  in
  let all = if chance random 3 then List.init (1 + Random.State.int random 3) one else [] in
  (List.map fst all, String.concat "" (List.map snd all))

let one ~seen ~seed number =
  let bias = Bias.of_program ~seed number in
  let random = Random.State.make [| seed; number |] in
  let prefix = f "p%d" number in
  let params, declarations = params ~seed ~prefix number in
  let values = scope ~seen ~seed ~random ~prefix ~params ~declared:[] number in
  let name, text, signals =
    match bias.root with
    | Any -> large ~seen ~seed ~random ~prefix ~params ~bias number
    | Small -> small values prefix
    | Cascade -> cascades values prefix
    | Handed_on -> handing_on values prefix
    | Errand -> errand values prefix
  in
  (name, declarations ^ text, signals)

(* {1 Ways to run a program} *)

(* Some programs always run; others start late, restart, or run only at some instants. *)
type kind = Always | After_switch | After_delayed_switch | Restarted | Replaced | At_events

let kinds = [| Always; After_switch; Restarted; At_events; Replaced; After_delayed_switch; Always |]

(* tcc has no room for more parts in one expression. *)
let most_parts = 150

let events =
  [ "edge b"; "when (x > 0.0)"; "tag e ()"; "after 0.3[s] ()"; "every 0.2[s] ()"; "now () ()" ]

(* Defines a signal function that runs the named one in a random way. *)
let running ~seed number name output =
  let random = Random.State.make [| seed; number; 2 |] in
  let seen = Coverage.create () in
  let literal () =
    Constant.literal (scope ~seen ~seed ~random ~prefix:"k" ~declared:[] number) output
  in
  let input = "proc i@(x, n, b, e, m, y, xs, d)" and event = one_of random events in
  let stays =
    match ((Bias.of_program ~seed number).root, output) with
    | Small, _ | Cascade, Type.Tuple [ _ ] -> not (chance random 6)
    | (Handed_on | Errand), _ -> chance random 2
    | (Any | Cascade), _ -> false
  in
  let late switch = f "%s (%s -> (%s, %s)) (\\_ -> %s)" switch input (literal ()) event name in
  let text =
    match kinds.(number mod Array.length kinds) with
    | _ when Type.scalars output > most_parts || stays -> name
    | Always -> name
    | After_switch -> late "switch"
    | After_delayed_switch -> late "dSwitch"
    | Restarted -> f "%s -> resetOn %s (i, %s)" input name event
    | Replaced -> f "%s -> rSwitch %s (i, mapE (\\_ -> %s) (%s))" input name name event
    | At_events -> f "%s -> hold %s (onEvent %s (tag (%s) i))" input (literal ()) name event
  in
  let run = name ^ "run" in
  (run, f "%s%s = %s\n\n" (signature run output) run text)

(* {1 The operator} *)

let is_operated number = number mod 5 = 3
let past = "import Past\n"
let import = "import Capability (Console, buttonPressed, buttonHeld, knob, toggle, mapClicked)\n"

(* Defines a signal function in which an operator changes the input of the program with this
   number. *)
let operated ~seed number =
  let random = Random.State.make [| seed; number; 3 |] in
  let name = f "operated%d" number in
  let label word = f "\"%s %d\"" word (number + Random.State.int random 2) in
  let pick choices = one_of random choices in
  let decimal () = f "%d.%d" (Random.State.int random 9) (Random.State.int random 100) in
  (* All knobs that may share a label must be equal. *)
  let dial () = f "dial%d (0.5 * %s) c" number (pick [ "2.5"; "3.0"; "(top + 1.0)" ]) in
  let text =
    String.concat ",\n     "
      [
        pick [ "x"; dial (); f "if buttonHeld %s c then x else %s" (label "held") (dial ()) ];
        pick [ "n"; f "if toggle %s False c then n else -n" (label "count") ];
        pick
          [ "b"; f "toggle %s True c && b" (label "gate"); f "b || buttonHeld %s c" (label "held") ];
        pick [ "e"; f "mergeE (tag (buttonPressed %s c) y) e" (label "go") ];
        "m";
        pick [ "y"; dial () ];
        pick [ "xs"; f "[x, %s, xs ! 1]" (dial ()) ];
        pick
          [
            "d";
            f "knob \"d %d\" (-%s[m]) 9.5[m] 0.0[m] c" number (decimal ());
            "case mapClicked c of\n        Event p -> p.x\n        NoEvent -> d";
          ];
      ]
  in
  ( name,
    f
      "dial%d :: Float -> Console -> Float\n\
       dial%d most c = knob (if most > 1.4 then \"much %d\" else \"little %d\") (-most) most 0.25 \
       c\n\n\
       %s :: Console -> %s -> %s\n\
       %s c (x, n, b, e, m, y, xs, d) =\n\
      \    (%s) where\n\
      \    top = 1.5\n\n"
      number number number number name (Type.text input_type) (Type.text input_type) name text )

(* {1 A camera} *)

let is_seeing number = number mod 60 = 6

let seen ~seed number =
  Seeing.definition (Random.State.make [| seed; number; 4 |]) ~number ~input:input_type

(* Defines [main] for programs with their numbers and outputs; also returns whether there is an
   operator. *)
let main ~sees ~seed programs =
  let numbers = List.map (fun (number, _, _) -> number) programs in
  let operating = List.filter is_operated numbers
  and seeing = List.filter (fun n -> sees && is_seeing n) numbers in
  let output =
    match programs with
    | [ (_, _, output) ] -> output
    | _ -> Type.Tuple (List.map (fun (_, _, output) -> output) programs)
  in
  let run (number, name, _) =
    if is_operated number then f "%s (%s c i)" name (fst (operated ~seed number))
    else if List.mem number seeing then f "%s (%s (c, i))" name (fst (seen ~seed number))
    else name ^ " i"
  in
  let text =
    match (programs, operating @ seeing) with
    | [ (_, run, _) ], [] -> f "%smain = %s\n" (signature "main" output) run
    | _, [] ->
        f "%smain = proc i -> (%s)\n" (signature "main" output)
          (String.concat ", " (List.map run programs))
    | _, _ :: _ ->
        f "main :: SF (Console, %s) %s\nmain = proc (c, i) -> (%s)\n" (Type.text input_type)
          (Type.text output)
          (String.concat ", " (List.map run programs))
  in
  let operators = List.map (fun number -> snd (operated ~seed number)) operating in
  let eyes = List.map (fun number -> snd (seen ~seed number)) seeing in
  ( ((if operating @ seeing = [] then "" else import) ^ if seeing = [] then "" else Seeing.imports),
    String.concat "" (operators @ eyes) ^ text )

(* {1 Tests} *)

let is_tried number = number / Bias.alike mod 7 = 1

(* The scope for a program's tests. It depends on the number alone, like the program itself. *)
let tried_scope ~seen ~seed number =
  let random = Random.State.make [| seed; number; 6 |] in
  scope ~seen ~seed ~random ~prefix:(f "p%d" number) ~declared:[] number

let tried ~seen ~seed (number, _, signals, run) =
  let scope = tried_scope ~seen ~seed number in
  if is_tried number && chance scope.random 2 then Trying.some scope { name = run; signals } else ""

(* {1 Whole programs} *)

let define ~seen ~seed number =
  let name, text, signals = one ~seen ~seed number in
  Coverage.count_words seen text;
  let run, definition = running ~seed number name (Type.Tuple signals) in
  ((number, name, signals, run), text ^ definition)

let main_of ~sees ~seed programs =
  main ~sees ~seed
    (List.map (fun (number, _, signals, run) -> (number, run, Type.Tuple signals)) programs)

let make ?(seen = Coverage.create ()) ?(sees = false) ?(with_tests = true) ~seed ~first ~count () =
  let defined = List.init count (fun i -> define ~seen ~seed (first + i)) in
  let programs = List.map fst defined in
  let imports, main = main_of ~sees ~seed programs in
  let checks = String.concat "" (List.map (tried ~seen ~seed) programs) in
  (* keeps the line numbers the same *)
  let blank = String.map (fun c -> if c = '\n' then c else ' ') Trying.imports in
  let trying = if checks = "" then "" else if with_tests then Trying.imports else blank in
  past ^ trying ^ imports
  ^ String.concat "" (Shared.text :: List.map snd defined)
  ^ main
  ^ if with_tests && checks <> "" then "\n" ^ checks else ""

let without_claims text =
  let is_claim line =
    let line = String.trim line in
    List.exists (fun word -> String.starts_with ~prefix:word line) [ "assert \""; "assume \"" ]
  in
  String.concat "\n"
    (List.filter (fun line -> not (is_claim line)) (String.split_on_char '\n' text))

let observed ~seed ~first ~count =
  let seen = Coverage.create () in
  let defined = List.init count (fun i -> define ~seen ~seed (first + i)) in
  let programs = List.map fst defined in
  let imports, main = main_of ~sees:false ~seed programs in
  let observer (number, _, signals, run) =
    let scope = tried_scope ~seen ~seed number in
    let reference = f "reference%d" number in
    (reference, Trying.observer scope { name = run; signals } (Scope.fresh scope "observed"))
  in
  let observers = List.map observer programs in
  let of_observer (name, observer) = Trying.test observer ^ Trying.reference name observer in
  let text =
    past ^ Trying.imports ^ imports
    ^ without_claims (String.concat "" (Shared.text :: List.map snd defined))
    ^ main ^ "\n"
    ^ String.concat "" (List.map of_observer observers)
  in
  (text, observers)

let signals ~seed number =
  let _, _, signals = one ~seen:(Coverage.create ()) ~seed number in
  List.length signals

let alone ~seed number ~component =
  let name, text, signals = one ~seen:(Coverage.create ()) ~seed number in
  let pattern = List.mapi (fun i _ -> if i = component then "z" else "_") signals in
  let chosen = name ^ "one" and output = List.nth signals component in
  let run, definition = running ~seed number chosen output in
  let imports, main = main ~sees:true ~seed [ (number, run, output) ] in
  f "%s%s%s%s%s%s = proc i -> z where\n    (%s) = %s i\n\n%s%s" past imports Shared.text text
    (signature chosen output) chosen (String.concat ", " pattern) name definition main
