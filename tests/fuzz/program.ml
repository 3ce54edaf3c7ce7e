open Choice

let f = Printf.sprintf

(* What all programs may use. *)
let library =
  {|import Control

choose :: Bool -> a -> a -> a
choose c x y = if c then x else y

swap :: (a, b) -> (b, a)
swap (x, y) = (y, x)

twice :: (a -> a) -> a -> a
twice g x = g (g x)

clampTo :: Ord a => a -> a -> a -> a
clampTo low high x = max low (min high x)

oneMore :: n[1] -> n[1]
oneMore x = 2 * x + 1

firstDiffers :: Eq a => a -> a -> Bool
firstDiffers x y = x /= y

data Series[u] n a = Series { step :: Float[u], entries :: Array n a, newest :: Maybe a }

latest :: a -> SF (Event a) a
latest x0 = proc e -> y where
    before = delay x0 y
    y = case e of
        Event x -> x
        NoEvent -> before

feedback :: c -> SF (a, c) (b, c) -> SF a b
feedback c0 sf = proc x -> y where
    (y, z) = sf (x, delay c0 z)

choosing :: Bool -> SF a b -> SF a b -> SF a b
choosing c g h = if c then g else h

twiceOver :: SF a b -> SF b b -> SF a b
twiceOver g h = g >>> h >>> h

class Measured a where
    size :: a -> Float
    bigger :: a -> a -> Bool
    bigger x y = size x > size y
    smooth :: SF a Float
    smooth = proc x -> 0.5 * size x + 0.5 * delay 0 (size x)

class Measured a => Renewed a where
    next :: a -> a
    next x = x
    paced :: Float -> SF a (Event a)
    paced least = proc x -> gate (Event (next x)) (size x >= least)

instance Measured Float[u] where
    size x = signum x
    bigger x y = x > y

instance Measured Int[u] where
    size n = toFloat (signum n)

instance Measured Bool where
    size b = if b then 1 else 0
    smooth = proc b -> delay 5 (if b then 10 else 0)

instance Measured a => Measured (Maybe a) where
    size m = maybe (-1) size m
    bigger _ y = size y > 0

instance Measured a => Measured (Event a) where
    size e = fromEvent (-1) (mapE size e)
    smooth = proc e -> hold 0 (mapE size e)

instance (Measured a, Measured b) => Measured (Either a b) where
    size e = either size size e

instance (Measured a, Measured b) => Measured (a, b) where
    size (x, y) = size x + size y
    smooth = proc (x, y) -> smooth x - smooth y

instance Measured a => Measured (Array n a) where
    size xs = foldl (\total x -> total + size x) 0 xs
    bigger xs ys = any (\x -> bigger x (at 0 x ys)) xs
    smooth = proc xs -> foldl max 0 (mapSF smooth xs)

instance Measured a => Measured (Series[u] n a) where
    size s = maybe (signum s.step) size s.newest
    bigger s t = s.step > t.step || bigger s.entries t.entries

instance Renewed Float[u] where
    next x = x + x

instance Renewed Bool where
    next b = not b

instance Renewed Int[u]

instance (Renewed a, Eq a) => Renewed (Maybe a) where
    next m = case m of
        Just x | Just (next x) /= m -> Just (next x)
        _ -> Nothing

instance Renewed a => Renewed (Event a) where
    paced least = proc e -> notYet (mapE (Event . next) e)

instance (Renewed a, Renewed b) => Renewed (a, b) where
    next (x, y) = if bigger x x then (next x, y) else (x, next y)

instance Renewed a => Renewed (Array n a) where
    next xs = imap (\i x -> at (i + 1) (next x) xs) xs
    paced least = proc xs -> tag (foldl mergeE NoEvent (mapSF (paced least) xs)) xs

instance Renewed a => Renewed (Series[u] n a) where
    next s = s { step = s.step * 2, newest = Just (next (s.entries ! 0)) }

largest :: Measured a => a -> a -> a
largest x y = if bigger x y then x else y

renewing :: Renewed a => a -> SF a a
renewing x0 = switch (proc x -> (x, notYet (paced 1 x))) (\x1 -> constant (next x1))

sideBySide :: SF a b -> SF c d -> SF (a, c) (b, d)
sideBySide g h = proc (x, y) -> (g x, h y)

|}

let input_type : Type.t =
  Tuple
    [
      Float; Int; Bool; Type.event Float; Type.maybe (Tuple [ Int; Bool ]); Float; Array (3, Float);
      Measure { metres = 1; seconds = 0 };
    ]

let define_function (s : Signal_function.scope) name =
  let values = s.values in
  let parameters = List.init (Random.State.int values.random 3) (fun _ -> Expression.any_type values) in
  let result = Expression.any_type values in
  let patterns = List.map (Expression.pattern values) parameters in
  let inside = Expression.bind (List.concat_map snd patterns) values in
  let head = String.concat " " (name :: List.map fst patterns) in
  let definition =
    if chance values.random 3 then begin
      Expression.note values "guards and where";
      let local = (Expression.fresh values "l", Expression.any_type values) in
      let within = Expression.bind [ local ] inside in
      f "%s\n    | %s = %s\n    | otherwise = %s\n  where\n    %s = (%s :: %s)" head
        (Expression.expression within 2 Bool)
        (Expression.expression within 2 result)
        (Expression.expression within 2 result)
        (fst local)
        (Expression.expression inside 2 (snd local))
        (Type.text (snd local))
    end
    else f "%s = %s" head (Expression.expression inside 3 result)
  in
  let text =
    f "%s :: %s\n%s\n\n" name
      (String.concat " -> " (List.map Type.text (parameters @ [ result ])))
      definition
  in
  (text, { s with values = { values with functions = (name, parameters, result) :: values.functions } })

let named_parameters values parameters =
  List.map (fun p -> (Expression.fresh values "p", p)) parameters

(* Parameters in scope: as values, functions and signal functions. *)
let bind_parameters (s : Signal_function.scope) named : Signal_function.scope =
  let some choose = List.filter_map choose named in
  let values =
    some (fun (name, (p : Signal_function.parameter)) ->
        match p with Value t -> Some (name, t) | Function _ | Signal_function _ -> None)
  and functions =
    some (fun (name, (p : Signal_function.parameter)) ->
        match p with Function (a, b) -> Some (name, [ a ], b) | Value _ | Signal_function _ -> None)
  and running =
    some (fun (name, (p : Signal_function.parameter)) ->
        match p with
        | Signal_function (input, output) ->
            Some { Signal_function.name; parameters = []; input; output }
        | Value _ | Function _ -> None)
  in
  let inside = Expression.bind values s.values in
  { values = { inside with functions = functions @ inside.functions }; known = running @ s.known }

let define_signal_function (s : Signal_function.scope) ~parameters ~input ~signals ~result name =
  let values = s.values in
  let named = named_parameters values parameters in
  let inside = bind_parameters s named in
  let output : Type.t =
    match (result : Signal_function.output) with
    | Computed output -> output
    | All_signals -> Tuple signals
  in
  let types =
    List.map Signal_function.parameter_text parameters
    @ [ f "SF %s %s" (Type.text input) (Type.text output) ]
  in
  let text =
    f "%s :: %s\n%s = %s\n\n" name (String.concat " -> " types)
      (String.concat " " (name :: List.map fst named))
      (Signal_function.body inside ~indent:"    " ~input ~signals result)
  in
  (text, { s with known = { name; parameters; input; output } :: s.known })

(* A call with an argument for each parameter. One that is a signal function is
   handed on as it came, or starts anew: to grow it would make ever more modes. *)
let call (s : Signal_function.scope) own (values : Expression.scope) (name, parameters) =
  let is_own name = List.mem_assoc name own in
  let functions = List.filter (fun (name, _, _) -> not (is_own name)) values.functions in
  let anew : Signal_function.scope =
    {
      values = { values with functions };
      known = List.filter (fun (n : Signal_function.named) -> not (is_own n.name)) s.known;
    }
  in
  let argument (p : Signal_function.parameter) =
    match p with
    | Value t -> Expression.expression values 2 t
    | Function _ | Signal_function _ -> (
        match List.filter (fun (_, p') -> p' = p) own with
        | (name, _) :: _ when not (chance values.random 3) -> name
        | _ -> Signal_function.argument anew 1 p)
  in
  String.concat " " (name :: List.map argument parameters)

(* What leads on from the value of an event or the result of a task: into one of
   the targets, chosen by that value. *)
let onward (values : Expression.scope) another =
  let call () = f "(%s)" (another values) in
  match Random.State.int values.random 4 with
  | 0 -> f "if %s then %s else %s" (Expression.expression values 2 Bool) (call ()) (call ())
  | 1 ->
      let t = Type.maybe Int in
      f "case (%s :: %s) of Nothing -> %s; Just _ -> %s" (Expression.expression values 2 t)
        (Type.text t) (call ()) (call ())
  | 2 ->
      let x = Expression.fresh values "x" in
      f "let %s = (%s :: Float) in %s" x
        (Expression.expression values 2 Float)
        (another (Expression.bind [ (x, Float) ] values))
  | _ -> call ()

let signature name parameters result =
  f "%s :: %s\n" name
    (String.concat " -> " (List.map Signal_function.parameter_text parameters @ [ result ]))

(* Some definitions, with the same kind of parameter in several of them. *)
let group (s : Signal_function.scope) start =
  let random = s.values.random in
  let any () = Expression.any_type s.values in
  let brought : Signal_function.parameter =
    if chance random 3 then Function (any (), any ()) else Signal_function (any (), any ())
  in
  let parameter () : Signal_function.parameter =
    if chance random 3 then brought else Value (any ())
  in
  List.init
    (1 + Random.State.int random 3)
    (fun _ ->
      (Expression.fresh s.values start, List.init (Random.State.int random 3) (fun _ -> parameter ())))

let note_brought values what named =
  List.iter
    (fun (_, (p : Signal_function.parameter)) ->
      match p with
      | Signal_function _ -> Expression.note values (what ^ " with a signal function as parameter")
      | Function _ -> Expression.note values (what ^ " with a function as parameter")
      | Value _ -> ())
    named

(* Definitions that switch into each other in tail position, with parameters. A
   switch back, to an earlier one or to itself, takes time; one onward may be at
   the first instant. *)
let define_modes (s : Signal_function.scope) =
  let values = s.values in
  let random = values.random in
  let any () = Expression.any_type values in
  let input = any () and output = any () in
  let modes = group s "m" in
  let define i (name, parameters) =
    Expression.note values "recursion through a switch";
    let named = named_parameters values parameters in
    let inside = bind_parameters s named in
    note_brought values "mode" named;
    let later = List.filteri (fun k _ -> k > i) modes in
    let earlier = later = [] || not (chance random 3) in
    let another values = call inside named values (one_of random (if earlier then modes else later)) in
    f "%s%s = %s\n\n"
      (signature name parameters (f "SF %s %s" (Type.text input) (Type.text output)))
      (String.concat " " (name :: List.map fst named))
      (Reactive.mode
         (Signal_function.maker inside)
         ~earlier
         ~continuation:(fun values -> onward values another)
         2 input output)
  in
  let texts = List.mapi define modes in
  let known =
    List.map (fun (name, parameters) -> { Signal_function.name; parameters; input; output }) modes
  in
  (String.concat "" texts, { s with known = known @ s.known })

(* Tasks that go on as each other, likewise. *)
let define_tasks (s : Signal_function.scope) =
  let values = s.values in
  let random = values.random in
  let any () = Expression.any_type values in
  let input = any () and output = any () and result = any () in
  let tasks = group s "t" in
  let define i (name, parameters) =
    Expression.note values "recursion of a task";
    let named = named_parameters values parameters in
    note_brought values "task" named;
    let inside = bind_parameters s named in
    let later = List.filteri (fun k _ -> k > i) tasks in
    let earlier = later = [] || not (chance random 3) in
    let first = Task.any_result (Signal_function.maker inside) in
    let text, bound = Expression.pattern inside.values first in
    let another values =
      if chance random 3 then f "return (%s :: %s)" (Expression.expression values 2 result) (Type.text result)
      else call inside named values (one_of random (if earlier then tasks else later))
    in
    f "%s%s = do\n    %s <- %s\n    %s\n\n"
      (signature name parameters
         (f "Task %s %s %s" (Type.text input) (Type.text output) (Type.text result)))
      (String.concat " " (name :: List.map fst named))
      text
      (Task.task (Signal_function.maker inside) ~slow:earlier 2 input output first)
      (onward (Expression.bind bound inside.values) another)
  in
  let texts = List.mapi define tasks in
  let run (name, parameters) =
    let started = Expression.fresh values "s" in
    let named = List.map fst (named_parameters values parameters) in
    let output = Type.either output result in
    ( f "%s%s = runTask (%s)\n\n"
        (signature started parameters (f "SF %s %s" (Type.text input) (Type.text output)))
        (String.concat " " (started :: named))
        (String.concat " " (name :: named)),
      { Signal_function.name = started; parameters; input; output } )
  in
  let runs = List.map run tasks in
  ( String.concat "" (texts @ List.map fst runs),
    { s with known = List.map snd runs @ s.known } )

(* Of a declared data type, some methods left to their defaults. *)
let define_instances (s : Signal_function.scope) ty =
  let head = Type.text ty and random = s.values.random in
  let given name arguments result =
    if chance random 4 then ""
    else
      let patterns = List.map (Expression.pattern s.values) arguments in
      let inside = Expression.bind (List.concat_map snd patterns) s.values in
      f "    %s = %s\n"
        (String.concat " " (name :: List.map fst patterns))
        (Expression.expression inside 3 result)
  in
  let size_text, bound = Expression.pattern s.values ty in
  let smooth =
    if chance random 2 then ""
    else f "    smooth = %s\n" (Signal_function.expression s 2 ty Type.Float)
  in
  let paced =
    if chance random 2 then ""
    else
      let least = Expression.fresh s.values "p" in
      let s = { s with values = Expression.bind [ (least, Type.Float) ] s.values } in
      f "    paced %s = %s\n" least (Signal_function.expression s 2 ty (Type.event ty))
  in
  f "instance Measured %s where\n    size %s = %s\n%s%s\ninstance Renewed %s where\n%s%s\n" head
    size_text
    (Expression.expression (Expression.bind bound s.values) 3 Float)
    (given "bigger" [ ty; ty ] Bool)
    smooth head
    (f "    next %s\n"
       (let text, bound = Expression.pattern s.values ty in
        f "%s = %s" text (Expression.expression (Expression.bind bound s.values) 3 ty)))
    paced

let one ~seen ~seed number =
  let bias = Bias.of_program ~seed number in
  let random = Random.State.make [| seed; number |] in
  let prefix = f "p%d" number in
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
  let values =
    {
      Expression.random;
      bias;
      methods = false;
      prefix;
      count = ref 0;
      seen;
      declared;
      variables = [];
      functions = [];
      run = None;
    }
  in
  let any () = Expression.any_type values in
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
    if k = 0 then s
    else functions (k - 1) (add (define_function s (Expression.fresh values "f")))
  in
  let rec signal_functions k s =
    if k = 0 then s
    else
      let parameters = List.init (Random.State.int random 3) (fun _ -> parameter ()) in
      let name = Expression.fresh values "s" in
      signal_functions (k - 1)
        (add
           (define_signal_function s ~parameters ~input:(any ())
              ~signals:(Signal_function.any_signals s)
              ~result:(Computed (any ())) name))
  in
  let s = { Signal_function.values; known = [] } in
  List.iter (fun ty -> Buffer.add_string out (define_instances s ty)) (List.rev declared);
  let s = functions (Random.State.int random 3) { s with values = { values with methods = true } } in
  let s = signal_functions (Random.State.int random 3) s in
  let s = if chance random (if bias.switches > 5 then 1 else 2) then add (define_modes s) else s in
  let s = if chance random (if bias.tasks > 1 then 2 else 5) then add (define_tasks s) else s in
  let signals = Signal_function.any_signals s in
  ignore
    (add
       (define_signal_function s ~parameters:[] ~input:input_type ~signals ~result:All_signals
          prefix));
  (prefix, Buffer.contents out, signals)

let main ~output body = f "main :: SF %s %s\nmain = proc i -> %s\n" (Type.text input_type) output body

let make ?(seen = Coverage.create ()) ~seed ~first ~count () =
  let programs = List.init count (fun i -> one ~seen ~seed (first + i)) in
  List.iter (fun (_, text, _) -> Coverage.count_words seen text) programs;
  let tuple texts = match texts with [ one ] -> one | _ -> f "(%s)" (String.concat ", " texts) in
  let main =
    main
      ~output:(tuple (List.map (fun (_, _, output) -> Type.text (Tuple output)) programs))
      (tuple (List.map (fun (name, _, _) -> name ^ " i") programs))
  in
  let texts = List.map (fun (_, text, _) -> text) programs in
  String.concat "" ((library :: texts) @ [ main ])

let signals ~seed number =
  let _, _, signals = one ~seen:(Coverage.create ()) ~seed number in
  List.length signals

let alone ~seed number ~component =
  let name, text, signals = one ~seen:(Coverage.create ()) ~seed number in
  let pattern = List.mapi (fun i _ -> if i = component then "y" else "_") signals in
  library ^ text
  ^ main
      ~output:(Type.text (List.nth signals component))
      (f "y where\n    (%s) = %s i" (String.concat ", " pattern) name)
