open Choice

type program = { name : string; signals : Type.t list }

type observer = {
  label : string;
  seconds : float;
  judge : string;
  claims : (string * string * string) list;
  equations : string list;
}

let f = Printf.sprintf
let imports = "import Geometry (Vec2)\nimport Sources\nimport Trial\n"

(* {1 Generated inputs} *)

let wave random =
  let number low = f "%d.%d" (low + Random.State.int random 4) (Random.State.int random 10) in
  match Random.State.int random 7 with
  | 0 -> f "%s * sine %s[Hz] ()" (number 0) (number 1)
  | 1 -> f "squareWave %s[Hz] ()" (number 1)
  | 2 -> f "chirp 0.5[Hz] %s[Hz] 0.4[s] ()" (number 1)
  | 3 -> f "whiteNoise %d ()" (Random.State.int random 1000)
  | 4 -> f "colouredNoise 0.1[s] %d ()" (Random.State.int random 1000)
  | 5 -> f "uniformNoise %d ()" (Random.State.int random 1000)
  | _ ->
      f "(if time () > 0.%d[s] then %s else -%s)"
        (1 + Random.State.int random 4)
        (number 0) (number 0)

let made_up random =
  let wave () = wave random in
  let event =
    one_of random
      [
        f "tag (edge (%s > 0.2)) x" (wave ());
        "tag (every 0.1[s] ()) y";
        "tag (after 0.2[s] ()) 1.5";
        "filterEvent (\\v -> v > 0.5) (Event x)";
      ]
  in
  [
    ("x", wave ());
    ("y", wave ());
    ("n", f "round (3 * (%s))" (wave ()));
    ("b", f "%s > 0" (wave ()));
    ("e", event);
    ("m", "if b then Just (n, x > y) else Nothing");
    ("xs", f "[y, %s, x]" (wave ()));
    ("d", f "0.5[m] * (%s)" (wave ()));
  ]

(* The pattern of the programs' input type. *)
let input = "(x, n, b, e, m, y, xs, d)"

(* {1 Observers} *)

(* [answer] is a Bool that is sometimes true. *)
let outcome ~answer (s : Scope.t) =
  let condition = Claim.condition s in
  match Random.State.int s.random 6 with
  | 0 -> f "by 0.3[s] (holds (verdict %s))" condition
  | 1 -> f "atEnd (holds (verdict %s))" condition
  | 2 -> f "verdict (%s)" condition
  (* conditions that are not immediately true *)
  | 3 -> f "respondsWithin 0.2[s] (%s, %s)" (Expression.expression s 2 Bool) answer
  | 4 -> f "implies (time () > 0.2[s]) (holds (verdict %s))" condition
  | _ -> condition

let observer (s : Scope.t) { name; signals } label =
  let random = s.random in
  let shown = List.mapi (fun k ty -> (f "v%d" k, ty)) signals in
  let left =
    match shown with [ (v, _) ] -> v | _ -> f "(%s)" (String.concat ", " (List.map fst shown))
  in
  let made_up = List.map (fun (name, value) -> f "%s = %s" name value) (made_up random) in
  let bound : (string * Type.t) list = [ ("x", Float); ("n", Int); ("b", Bool) ] in
  let seen = Scope.bind (bound @ shown) s in
  let claim k =
    let word = if chance random 3 then "assume" else "assert" in
    (word, f "said %d of %s" k label, outcome ~answer:"b" seen)
  in
  {
    label;
    seconds = one_of random [ 0.1; 0.4; 0.5 ];
    judge = outcome ~answer:"b" seen;
    claims = List.init (Random.State.int random 3) claim;
    equations = made_up @ [ f "%s = %s %s" left name input ];
  }

let indented lines = String.concat "" (List.map (fun line -> "\n    " ^ line) lines)

let test { label; seconds; judge; claims; equations } =
  let claim (word, label, said) = f "%s %S (%s)" word label said in
  f "test %S = during %g[s] (proc () -> %s where%s)\n\n" label seconds judge
    (indented (equations @ List.map claim claims))

let reference name { judge; claims; equations; _ } =
  let verdict text = f "verdict (%s)" text in
  let claimed = List.map (fun (_, _, said) -> verdict said) claims in
  f "%s :: SF () (Verdict, %s)\n%s = proc () -> (%s, (%s)) where%s\n\n" name
    (f "(%s)" (String.concat ", " ("()" :: List.map (fun _ -> "Verdict") claims)))
    name (verdict judge)
    (String.concat ", " ("()" :: claimed))
    (indented equations)

(* {1 Trials and traces} *)

let trial (s : Scope.t) label =
  let random = s.random in
  let bound : (string * Type.t) list =
    [ ("t.touches", Bool); ("t.driven", Measure { metres = 1; seconds = 0 }); ("near", Float) ]
  in
  let judge =
    one_of random
      [
        "neverTouches";
        "keepsOff 0.2[m]";
        "bothOf neverTouches (endsWithin 9[s])";
        "comesFar 1[m] 8[s]";
        "arrives 5[s] 10[cm] (Vec2 { x = 1[m], y = -2[m] })";
        f
          "proc t -> verdict (%s) where\n\
          \        near = %s (t.clearance / 1[m])\n\
          \        assert \"still said\" (%s)"
          (outcome ~answer:"t.touches" (Scope.bind bound { s with run = None }))
          (one_of random [ "meanOf"; "largestOf"; "smallestOf"; "lastOf" ])
          (Claim.condition (Scope.bind bound s));
      ]
  in
  let seeds = one_of random [ "1 `to` 3"; "to 7 9"; "holdsWith 0.9 0.95 (1 `to` 100)" ] in
  f
    "trial %S = Trial {\n\
    \    world = \"room.toml\",\n\
    \    lasts = %d[s],\n\
    \    seeds = %s,\n\
    \    judge = %s }\n\n"
    label
    (1 + Random.State.int random 9)
    seeds judge

let some (s : Scope.t) program =
  let label = Scope.fresh s "tried" in
  match Random.State.int s.random 5 with
  | 0 ->
      Scope.note s "golden trace";
      f "test %S = trace \"%s.csv\" \"as it was.csv\"\n\n" label label
  | 1 ->
      Scope.note s "trial";
      trial s label
  | _ ->
      Scope.note s "test by itself";
      test (observer s program label)
