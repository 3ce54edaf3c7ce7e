open Choice

type parameter =
  | Value of Type.t
  | Function of Type.t * Type.t
  | Signal_function of Type.t * Type.t

type named = { name : string; parameters : parameter list; input : Type.t; output : Type.t }

let f = Printf.sprintf

let parameter_text = function
  | Value t -> Type.text t
  | Function (a, b) -> f "(%s -> %s)" (Type.text a) (Type.text b)
  | Signal_function (a, b) -> f "SF %s %s" (Type.text a) (Type.text b)

type scope = { values : Scope.t; known : named list }

let static s fuel ty = Expression.expression { s.values with run = None } fuel ty
let literal s ty = if chance s.values.random 3 then static s 1 ty else Constant.literal s.values ty

(* A known signal function, with arguments for its parameters. *)
let rec applied s fuel { name; parameters; _ } =
  match parameters with
  | [] -> name
  | _ -> f "(%s)" (String.concat " " (name :: List.map (argument s fuel) parameters))

and argument s fuel = function
  | Value t -> static s 1 t
  | Function (a, b) -> lambda s fuel a b
  | Signal_function (a, b) -> expression s (fuel - 1) a b

and lambda s fuel a b =
  let values = { s.values with run = None } in
  let text, bound = Pattern.any values a in
  f "(\\%s -> %s)" text (Expression.expression (Scope.bind bound values) (min fuel 2) b)

and expression s fuel (a : Type.t) (b : Type.t) =
  let random = s.values.random in
  let arr () = f "(arr %s)" (lambda s (fuel + 1) a b) in
  let sub = expression s (fuel - 1) in
  let named = List.filter (fun n -> n.input = a && n.output = b) s.known in
  let alternatives =
    [
      (2, arr);
      (1, fun () -> f "(constant %s)" (literal s b));
      ((if named = [] then 0 else 8), fun () -> applied s fuel (one_of random named));
      ((if a = b then 2 else 0), fun () -> f "(delay %s)" (literal s b));
      ((if a = b then 1 else 0), fun () -> one_of random [ "returnA"; "identity" ]);
      ( (match b with Array (_, t) when t = a -> 5 | _ -> 0),
        fun () -> f "(window %s :: SF %s %s)" (literal s a) (Type.text a) (Type.text b) );
      ((match b with Bool -> 1 | _ -> 0), fun () -> "atStart");
      ( (match (a, b) with Float, Float -> 4 | _ -> 0),
        fun () ->
          one_of random
            [
              "(integral >>> arr (\\x -> x / 1[s]))";
              "(derivative >>> arr (\\x -> x * 1[s]))";
              "(sine 0.7[Hz])";
              "(squareWave 0.3[Hz])";
              "(chirp 0.1[Hz] 2[Hz] 3[s])";
              "(whiteNoise 1)";
              "(colouredNoise 0.4[s] 2)";
              "(uniformNoise (-3))";
              "(lowPass 0.3[s])";
              "(movingAverage [1, 2, 1])";
              "previous";
              "(rateLimit 2[1/s])";
            ] );
      ( (match (a, b) with Array (n, _), Array (n', _) when n = n' && fuel > 0 -> 10 | _ -> 0),
        fun () ->
          match (a, b) with
          | Array (_, x), Array (_, y) ->
              f "(mapSF %s :: SF %s %s)" (sub x y) (Type.text a) (Type.text b)
          | _ -> arr () );
      ( (match (a, b) with
        | Measure u, Measure v when v = { u with seconds = u.seconds + 1 } -> 6
        | Measure u, Measure v when v = { u with seconds = u.seconds - 1 } -> 6
        | _ -> 0),
        fun () ->
          match (a, b) with
          | Measure u, Measure v -> if v.seconds > u.seconds then "integral" else "derivative"
          | _ -> arr () );
      ( (match b with Measure { metres = 0; seconds = 1 } -> 6 | _ -> 0),
        fun () -> one_of random [ "time"; "time"; "stepTime" ] );
      ( (match (a, b) with
        | Bool, Measure { metres = 0; seconds = 1 } -> 8
        | Bool, Float -> 3
        | _ -> 0),
        fun () ->
          match b with
          | Float ->
              one_of random
                [ "(timeSince >>> arr nanoseconds)"; "(timeSince >>> arr (\\x -> x / 1[s]))" ]
          | _ -> "timeSince" );
      ((match (a, b) with Float, Bool -> 3 | _ -> 0), fun () -> "(hysteresis (-0.5) 0.5)");
      ((match (a, b) with Bool, Bool -> 2 | _ -> 0), fun () -> "(debounce 0.25[s])");
      ( (match b with
        | Float when s.values.methods && Type.has_instances ~measured:true a -> 4
        | _ -> 0),
        fun () -> f "(smooth :: SF %s Float)" (Type.text a) );
      ( (if s.values.methods && b = Type.event a && Type.has_instances ~measured:false a then 5
         else 0),
        fun () ->
          f "((paced :: Float -> SF %s %s) %s)" (Type.text a) (Type.text b) (literal s Float) );
      ( (if s.values.methods && a = b && Type.has_instances ~measured:false a then 3 else 0),
        fun () ->
          f "((renewing :: %s -> SF %s %s) %s)" (Type.text a) (Type.text a) (Type.text b)
            (literal s a) );
      ( (match b with Float -> 2 | _ -> 0),
        fun () ->
          one_of random
            [
              "(time >>> arr (\\x -> x / 1[s]))";
              (* The result shows whether a mode sees a dt at its own first instant. *)
              "(time >>> arr (\\x -> x + 1[s]) >>> derivative)";
            ] );
      ((if a = Type.event b then 6 else 0), fun () -> f "(latest %s)" (literal s b));
    ]
  in
  let deeper =
    if fuel <= 0 then []
    else
      let middle = Scope.any_type s.values in
      [
        (4, fun () -> f "(%s >>> %s)" (sub a middle) (sub middle b));
        (1, fun () -> f "(%s <<< %s)" (sub middle b) (sub a middle));
        (2, fun () -> f "(choosing %s %s %s)" (static s 1 Bool) (sub a b) (sub a b));
        ( 2,
          fun () ->
            let inner = sub (Tuple [ a; middle ]) (Tuple [ b; middle ]) in
            f "(feedback %s %s)" (literal s middle) inner );
        ( 1,
          fun () ->
            let inner = sub (Tuple [ a; middle ]) (Tuple [ b; middle ]) in
            f "(loop (second (delay %s) >>> %s))" (literal s middle) inner );
        (2, fun () -> inline s fuel a b);
        ( 1,
          fun () ->
            let n = 1 + Random.State.int random 3 and element = Scope.any_type s.values in
            let many : Type.t = Array (n, middle) and results : Type.t = Array (n, element) in
            f "(%s >>> (mapSF %s :: SF %s %s) >>> %s)" (sub a many) (sub middle element)
              (Type.text many) (Type.text results) (sub results b) );
        ( 1,
          fun () ->
            let n = 1 + Random.State.int random 3 in
            let all = String.concat ", " (List.init n (fun _ -> sub a middle)) in
            let together =
              if Choice.chance random 2 then f "parB [%s]" all
              else
                f "arr (\\x -> (generate (const x) :: Array %d (%s))) >>> parZ [%s]" n (Type.text a)
                  all
            in
            f "(%s >>> %s)" together (sub (Array (n, middle)) b) );
        ( (if a = b then 1 else 0),
          fun () ->
            Scope.note s.values "array of signal functions";
            let stages = List.init (1 + Random.State.int random 3) (fun _ -> sub a b) in
            f "(foldl (>>>) identity [%s])" (String.concat ", " stages) );
        (1, fun () -> f "(twiceOver %s %s)" (sub a b) (sub b b));
        ( (match b with Tuple [ _; _ ] -> 4 | _ -> 0),
          fun () ->
            match b with Tuple [ x; y ] -> f "(%s &&& %s)" (sub a x) (sub a y) | _ -> arr () );
        ( (match (a, b) with Tuple [ _; _ ], Tuple [ _; _ ] -> 8 | _ -> 0),
          fun () ->
            match (a, b) with
            | Tuple [ x; y ], Tuple [ x'; y' ] when y = y' && chance random 2 ->
                f "(first %s)" (sub x x')
            | Tuple [ x; y ], Tuple [ x'; y' ] when x = x' -> f "(second %s)" (sub y y')
            | Tuple [ x; y ], Tuple [ x'; y' ] -> f "(%s *** %s)" (sub x x') (sub y y')
            | _ -> arr () );
      ]
  in
  let reactive = Reactive.alternatives (maker s) fuel a b @ Task.alternatives (maker s) fuel a b in
  (weighted random (alternatives @ deeper @ reactive)) ()

and maker s =
  {
    Reactive.values = s.values;
    signal_function = (fun values fuel a b -> expression { s with values } fuel a b);
  }

(* {1 Instances} *)

and typed_expression values fuel ty =
  f "(%s :: %s)" (Expression.expression values fuel ty) (Type.text ty)

(* An instance in place of an expression. *)
and running s values fuel ty =
  let input = Scope.any_type s.values in
  let candidates = List.filter (fun n -> n.output = ty) s.known in
  if chance s.values.random 8 then
    let argument = Scope.any_type s.values in
    f "(%s %s %s)"
      (of_functions s fuel input argument ty)
      (typed_expression values fuel input)
      (typed_expression { values with run = None } fuel argument)
  else if candidates <> [] && chance s.values.random 2 then
    let n = one_of s.values.random candidates in
    f "(%s (%s))" (applied s 1 n) (Expression.expression values fuel n.input)
  else
    match (ty, Random.State.int s.values.random 4) with
    | Float, 0 -> "(time () / 1[s])"
    | Measure { metres; seconds }, (0 | 1) ->
        let rate = Type.measure ~metres ~seconds:(seconds - 1) in
        f "(integral %s)" (typed_expression values fuel rate)
    | Measure { metres; seconds }, 2 ->
        let amount = Type.measure ~metres ~seconds:(seconds + 1) in
        f "(derivative %s)" (typed_expression values fuel amount)
    | Float, 1 -> f "(derivative %s * 1[s])" (Expression.expression values fuel Float)
    | _ when chance s.values.random 2 ->
        f "(delay %s %s)" (literal s ty) (Expression.expression values fuel ty)
    | _ -> f "(%s %s)" (expression s 1 input ty) (Expression.expression values fuel input)

and run s = Some (running s)

(* A stateless instance that can be used anywhere in the proc with these signals. *)
and sense signals (values : Scope.t) _ (ty : Type.t) =
  let of_type t = List.filter (fun (_, t') -> t' = t) signals in
  let measured (_, t) = Type.has_instances ~measured:true t in
  Scope.note values "instance in a branch or function";
  match (ty, List.filter measured signals, of_type ty, of_type Bool) with
  | Float, (_ :: _ as them), _, _ when values.methods && chance values.random 2 ->
      let x, t = one_of values.random them in
      f "((smooth :: SF %s Float) %s)" (Type.text t) x
  | _, _, (_ :: _ as them), (_ :: _ as conditions) when chance values.random 2 ->
      let x = fst (one_of values.random them) and b = fst (one_of values.random conditions) in
      let other = Constant.literal values ty in
      f "((proc (y, b) -> if b then y else %s) (%s, %s))" other x b
  | _, _, (_ :: _ as them), _ -> f "(identity %s)" (fst (one_of values.random them))
  | _ -> f "(constant %s ())" (Constant.literal values ty)

(* A signal function whose output is a function. The modes of a switch may output different
   functions. *)
and of_functions s fuel a argument result =
  let values = { s.values with run = None } in
  let text, bound = Pattern.any values a in
  let made values = Expression.lambda (Scope.bind bound values) (min fuel 2) argument result in
  if chance values.random 2 then (
    Scope.note values "function out of a signal function";
    f "(arr (\\%s -> %s))" text (made values))
  else (
    Scope.note values "function out of a switch";
    let payload = Scope.any_type values in
    let event = Type.event payload in
    let brought, more = Pattern.any values payload in
    f "(%s (proc %s -> (%s, (%s :: %s))) (\\%s -> arr (\\%s -> %s)))"
      (one_of values.random [ "switch"; "dSwitch" ])
      text (made values)
      (Expression.expression (Scope.bind bound values) (min fuel 2) event)
      (Type.text event) brought text
      (made (Scope.bind more values)))

(* {1 Procs} *)

and inline s fuel a b =
  let text, bound = Pattern.any s.values a in
  let outside = Scope.bind bound s.values in
  let values = { outside with run = run s } in
  if chance s.values.random 3 then
    let middle = Scope.any_type s.values in
    let name, bound = Pattern.any outside middle in
    let last, input =
      if chance s.values.random 2 then ("returnA", b)
      else
        let input = Scope.any_type s.values in
        (expression s (fuel - 1) input b, input)
    in
    f "(proc %s -> do %s <- %s -< %s; %s -< %s)" text name
      (expression s (fuel - 1) a middle)
      (Expression.expression values 1 a)
      last
      (Expression.expression { (Scope.bind bound outside) with run = run s } 1 input)
  else f "(proc %s -> %s)" text (Expression.expression values (min fuel 2) b)

let any_equation s ~signals ~later (name, ty) =
  let random = s.values.random in
  let e ?(scope = signals) fuel ty = Expression.expression scope fuel ty in
  match (Random.State.int random 8, (ty : Type.t)) with
  | 0, Float ->
      Scope.note s.values "feedback through integral";
      f "%s = integral %s / 1[s]" name (e ~scope:later 2 Float)
  | (0 | 1), Measure { metres; seconds } ->
      let rate = Type.measure ~metres ~seconds:(seconds - 1) in
      f "%s = integral %s" name (typed_expression later 2 rate)
  | (0 | 1 | 2), _ ->
      Scope.note s.values "feedback through delay";
      f "%s = delay %s %s" name (literal s ty) (e ~scope:later 2 ty)
  | 3, _ when chance random 3 ->
      let input = Scope.any_type s.values in
      (* The output of the machine, or anything that may depend on it. *)
      let late, fed_back =
        if chance random 2 then (ty, name)
        else
          let late = Scope.any_type s.values in
          (late, typed_expression later 2 late)
      in
      f "%s = %s (%s, %s)" name (Circle.machine (maker s) input ~late ty) (e 2 input) fed_back
  | 3, _ ->
      let input = Scope.any_type s.values in
      f "%s = %s %s" name (expression s 2 input ty) (e 2 input)
  | _, _ -> f "%s = %s" name (e (3 + s.values.bias.depth) ty)

(* One of the results of a wide function, if there is one. *)
let of_wide s ~signals ty =
  let call { name; input; _ } = f "%s %s" name (Expression.expression signals 1 input) in
  match List.find_opt (fun n -> n.output = Wide.output && n.parameters = []) s.known with
  | Some n when chance s.values.random 4 -> Wide.part s.values ty ~call:(call n)
  | Some _ | None -> None

let equation s ~signals ~later (name, ty) =
  match of_wide s ~signals ty with
  | Some text -> f "%s = %s" name text
  | None -> any_equation s ~signals ~later (name, ty)

(* Two signals computed together: the second component may depend on the first one at the same
   instant. *)
let pair s ~signals ((x, t) as first) (y, u) =
  let with_first = Scope.bind [ first ] signals in
  Scope.note s.values "pair of signals";
  let a = Scope.any_type s.values and b = Scope.any_type s.values in
  match Random.State.int s.values.random 3 with
  | 0 ->
      f "(%s, %s) = (%s, %s)" x y
        (Expression.expression signals 2 t)
        (Expression.expression with_first 2 u)
  | 1 ->
      f "(%s, %s) = (%s *** %s) (%s, %s)" x y (expression s 1 a t) (expression s 1 b u)
        (Expression.expression signals 2 a)
        (Expression.expression with_first 2 b)
  | _ ->
      f "(%s, %s) = sideBySide %s %s (%s, %s)" x y (expression s 1 a t) (expression s 1 b u)
        (Expression.expression signals 2 a)
        (Expression.expression with_first 2 b)

(* Equations of a chain of arrays, in which the last one often feeds back to the first an instant
   later, and the signals that show their values. *)
let chain s ~signals ~shown =
  let values : Scope.t = s.values in
  let makers =
    { Chain.expression = Expression.expression; instances = Some (fun a b -> expression s 1 a b) }
  in
  let n = Chain.size signals and t = Scope.any_type values in
  let before = (Scope.fresh values "d", Type.Array (n, t)) in
  let is_fed_back = chance values.random 2 in
  let scope = if is_fed_back then Scope.bind [ before ] signals else signals in
  let bindings =
    if is_fed_back then Chain.make scope makers ~last:t n else Chain.make scope makers n
  in
  let equation { Chain.name; text; _ } = f "%s = %s" name text in
  let feedback =
    if not is_fed_back then []
    else (
      Scope.note values "chain in feedback";
      let last = List.nth bindings (List.length bindings - 1) in
      [ f "%s = delay %s %s" (fst before) (literal s (snd before)) last.Chain.name ])
  in
  let comes_to (name, ty) =
    f "%s = %s" name (Constant.annotated (Chain.result scope makers bindings ty) ty)
  in
  let found = List.rev_map (fun { Chain.name; ty; _ } -> (name, ty)) bindings in
  (List.map comes_to shown @ feedback @ List.map equation bindings, shown @ found)

let local_function s ~signals name argument result =
  Scope.note s.values "local function";
  let text, bound = Pattern.any s.values argument in
  let inside = { (Scope.bind bound signals) with Scope.run = None } in
  f "%s %s = %s" name text (Expression.expression inside 2 result)

(* Assertions never change the output, whatever they contain. *)
let claim s signals =
  Scope.note s.values "assertion";
  let word = if chance s.values.random 5 then "assume" else "assert" in
  f "%s \"%s\" %s" word (Scope.fresh s.values "said") (Claim.condition signals)

type output = Computed of Type.t | All_signals

let any_signals s =
  List.init
    (2 + s.values.bias.width + Random.State.int s.values.random 5)
    (fun _ -> Scope.any_type s.values)

let body s ~indent ~input ~signals output =
  let random = s.values.random in
  let text, bound = Pattern.any s.values input in
  let fresh start = Scope.fresh s.values start in
  (* Define static values and signal functions first, so that instances may use them. *)
  let constant = (fresh "k", Scope.any_type s.values) in
  let constant_text =
    f "%s = (%s :: %s)" (fst constant) (static s 2 (snd constant)) (Type.text (snd constant))
  in
  let s = { s with values = Scope.bind [ constant ] s.values } in
  let local =
    let input = Scope.any_type s.values and output = Scope.any_type s.values in
    { name = fresh "sf"; parameters = []; input; output }
  in
  let local_text = f "%s = %s" local.name (expression s 2 local.input local.output) in
  let s = { s with known = local :: s.known } in
  let signals = List.map (fun t -> (fresh "v", t)) signals in
  let instances (values : Scope.t) =
    { values with run = run s; senses = Some (sense values.variables) }
  in
  let later = instances (Scope.bind (bound @ signals) s.values) in
  let h = (fresh "h", Scope.any_type s.values, Scope.any_type s.values) in
  let rec equations found known = function
    | [] -> (known, found)
    | first :: second :: others when chance random 4 ->
        let text = pair s ~signals:(instances known) first second in
        equations (text :: found) (Scope.bind [ first; second ] known) others
    | first :: others ->
        let text = equation s ~signals:(instances known) ~later first in
        equations (text :: found) (Scope.bind [ first ] known) others
  in
  let chain_texts, chain_signals, others =
    if not (chance random (max 2 (10 / s.values.bias.chains))) then ([], [], signals)
    else
      let shows (_, (ty : Type.t)) =
        match ty with
        | Float | Int | Bool -> not (chance random 3)
        | Measure _ | Tuple _ | Array _ | Data _ -> false
      in
      let shown, others = List.partition shows signals in
      let texts, found = chain s ~signals:(instances (Scope.bind bound s.values)) ~shown in
      (texts, found, others)
  in
  let name, argument, result = h in
  let h_text = local_function s ~signals:(Scope.bind bound s.values) name argument result in
  let known = Scope.bind (chain_signals @ bound) s.values in
  let known = { known with functions = (name, [ argument ], result) :: known.functions } in
  let known, found = equations ([ h_text; local_text; constant_text ] @ chain_texts) known others in
  let found = if chance random 3 then claim s (instances known) :: found else found in
  let result =
    match output with
    | Computed t -> Expression.expression (instances known) 3 t
    | All_signals -> f "(%s)" (String.concat ", " (List.map fst signals))
  in
  String.concat "\n"
    (f "proc %s -> %s where" text result
    :: List.map (fun text -> indent ^ text) (shuffled random found))
