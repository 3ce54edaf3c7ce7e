open Choice

let f = Printf.sprintf

let function_ (s : Signal_function.scope) name =
  let values = s.values in
  let parameters = List.init (Random.State.int values.random 3) (fun _ -> Scope.any_type values) in
  let result = Scope.any_type values in
  let patterns = List.map (Pattern.any values) parameters in
  let inside = Scope.bind (List.concat_map snd patterns) values in
  let head = String.concat " " (name :: List.map fst patterns) in
  let definition =
    if chance values.random 3 then (
      Scope.note values "guards and where";
      let local = (Scope.fresh values "l", Scope.any_type values) in
      let within = Scope.bind [ local ] inside in
      f "%s\n    | %s = %s\n    | otherwise = %s\n  where\n    %s = (%s :: %s)" head
        (Expression.expression within 2 Bool)
        (Expression.expression within 2 result)
        (Expression.expression within 2 result)
        (fst local)
        (Expression.expression inside 2 (snd local))
        (Type.text (snd local)))
    else f "%s = %s" head (Expression.expression inside 3 result)
  in
  let text =
    f "%s :: %s\n%s\n\n" name
      (String.concat " -> " (List.map Type.text (parameters @ [ result ])))
      definition
  in
  ( text,
    { s with values = { values with functions = (name, parameters, result) :: values.functions } }
  )

let named_parameters values parameters = List.map (fun p -> (Scope.fresh values "p", p)) parameters

(* Brings parameters into scope: as values, functions and signal functions. *)
let bind_parameters (s : Signal_function.scope) named : Signal_function.scope =
  let some choose = List.filter_map choose named in
  let values =
    some (fun (name, (p : Signal_function.parameter)) ->
        match p with Value t -> Some (name, t) | Function _ | Signal_function _ -> None)
  and functions =
    some (fun (name, (p : Signal_function.parameter)) ->
        match p with
        | Function (a, b) -> Some (name, [ a ], b)
        | Value _ | Signal_function _ -> None)
  and running =
    some (fun (name, (p : Signal_function.parameter)) ->
        match p with
        | Signal_function (input, output) ->
            Some { Signal_function.name; parameters = []; input; output }
        | Value _ | Function _ -> None)
  in
  let inside = Scope.bind values s.values in
  { values = { inside with functions = functions @ inside.functions }; known = running @ s.known }

let signal_function (s : Signal_function.scope) ~parameters ~input ~signals ~result name =
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

let wide (s : Signal_function.scope) =
  let name = Scope.fresh s.values "s" in
  let text, input = Wide.definition s.values name in
  (text, { s with known = { name; parameters = []; input; output = Wide.output } :: s.known })

(* A call with an argument for each parameter. An argument that is a signal function is either
   passed on unchanged or starts anew; wrapping it would create more modes with every call. *)
let call (s : Signal_function.scope) own (values : Scope.t) (name, parameters) =
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
    | Value Int when chance values.random 2 -> Cascade.one_of_few values
    | Value t -> Expression.expression values 2 t
    | Function _ | Signal_function _ -> (
        match List.filter (fun (_, p') -> p' = p) own with
        | (name, _) :: _ when not (chance values.random 3) -> name
        | _ -> Signal_function.argument anew 1 p)
  in
  String.concat " " (name :: List.map argument parameters)

(* Continues with one of the targets, chosen by the value of an event or the result of a task. *)
let onward (values : Scope.t) another =
  let call () = f "(%s)" (another values) in
  match Random.State.int values.random 4 with
  | 0 -> f "if %s then %s else %s" (Expression.expression values 2 Bool) (call ()) (call ())
  | 1 ->
      let t = Type.maybe Int in
      f "case (%s :: %s) of Nothing -> %s; Just _ -> %s"
        (Expression.expression values 2 t)
        (Type.text t) (call ()) (call ())
  | 2 ->
      let x = Scope.fresh values "x" in
      f "let %s = (%s :: Float) in %s" x
        (Expression.expression values 2 Float)
        (another (Scope.bind [ (x, Float) ] values))
  | _ -> call ()

let signature name parameters result =
  f "%s :: %s\n" name
    (String.concat " -> " (List.map Signal_function.parameter_text parameters @ [ result ]))

(* A group of definitions; several of them have the same kind of parameter. *)
let group (s : Signal_function.scope) start =
  let random = s.values.random in
  let any () = Scope.any_type s.values in
  let brought : Signal_function.parameter =
    if chance random 3 then Function (any (), any ()) else Signal_function (any (), any ())
  in
  let parameter () : Signal_function.parameter =
    match Random.State.int random 6 with
    | 0 | 1 -> brought
    | 2 | 3 -> Value Int
    | _ -> Value (any ())
  in
  List.init
    (1 + Random.State.int random 3)
    (fun _ ->
      (Scope.fresh s.values start, List.init (Random.State.int random 3) (fun _ -> parameter ())))

let note_brought values what named =
  List.iter
    (fun (_, (p : Signal_function.parameter)) ->
      match p with
      | Signal_function _ -> Scope.note values (what ^ " with a signal function as parameter")
      | Function _ -> Scope.note values (what ^ " with a function as parameter")
      | Value _ -> ())
    named

(* Definitions with parameters that switch into each other in tail position. A switch to an
   earlier mode or to itself takes time; a switch to a later one may happen at the first instant. *)
let modes (s : Signal_function.scope) =
  let values = s.values in
  let random = values.random in
  let any () = Scope.any_type values in
  let input = any () and output = any () in
  let modes = group s "m" in
  let define i (name, parameters) =
    Scope.note values "recursion through a switch";
    let named = named_parameters values parameters in
    let inside = bind_parameters s named in
    note_brought values "mode" named;
    let later = List.filteri (fun k _ -> k > i) modes in
    let earlier = later = [] || not (chance random 3) in
    let another values =
      call inside named values (one_of random (if earlier then modes else later))
    in
    f "%s%s = %s\n\n"
      (signature name parameters (f "SF %s %s" (Type.text input) (Type.text output)))
      (String.concat " " (name :: List.map fst named))
      (Reactive.mode (Signal_function.maker inside) ~earlier
         ~continuation:(fun values -> onward values another)
         2 input output)
  in
  let texts = List.mapi define modes in
  let known =
    List.map (fun (name, parameters) -> { Signal_function.name; parameters; input; output }) modes
  in
  (String.concat "" texts, { s with known = known @ s.known })

(* Tasks that continue as each other, under the same rules. *)
let tasks (s : Signal_function.scope) =
  let values = s.values in
  let random = values.random in
  let any () = Scope.any_type values in
  let input = any () and output = any () and result = any () in
  let tasks = group s "t" in
  let define i (name, parameters) =
    Scope.note values "recursion of a task";
    let named = named_parameters values parameters in
    note_brought values "task" named;
    let inside = bind_parameters s named in
    let later = List.filteri (fun k _ -> k > i) tasks in
    let earlier = later = [] || not (chance random 3) in
    let first = Task.any_result (Signal_function.maker inside) in
    let text, bound = Pattern.any inside.values first in
    let another values =
      if chance random 3 then
        f "return (%s :: %s)" (Expression.expression values 2 result) (Type.text result)
      else call inside named values (one_of random (if earlier then tasks else later))
    in
    f "%s%s = do\n    %s <- %s\n    %s\n\n"
      (signature name parameters
         (f "Task %s %s %s" (Type.text input) (Type.text output) (Type.text result)))
      (String.concat " " (name :: List.map fst named))
      text
      (Task.task (Signal_function.maker inside) ~slow:earlier 2 input output first)
      (onward (Scope.bind bound inside.values) another)
  in
  let texts = List.mapi define tasks in
  let run (name, parameters) =
    let started = Scope.fresh values "s" in
    let named = List.map fst (named_parameters values parameters) in
    let output = Type.either output result in
    ( f "%s%s = runTask (%s)\n\n"
        (signature started parameters (f "SF %s %s" (Type.text input) (Type.text output)))
        (String.concat " " (started :: named))
        (String.concat " " (name :: named)),
      { Signal_function.name = started; parameters; input; output } )
  in
  let runs = List.map run tasks in
  (String.concat "" (texts @ List.map fst runs), { s with known = List.map snd runs @ s.known })

(* Class instances of a declared data type; some methods keep their defaults. *)
let instances (s : Signal_function.scope) ty =
  let head = Type.text ty and random = s.values.random in
  let given name arguments result =
    if chance random 4 then ""
    else
      let patterns = List.map (Pattern.any s.values) arguments in
      let inside = Scope.bind (List.concat_map snd patterns) s.values in
      f "    %s = %s\n"
        (String.concat " " (name :: List.map fst patterns))
        (Expression.expression inside 3 result)
  in
  let size_text, bound = Pattern.any s.values ty in
  let smooth =
    if chance random 2 then ""
    else f "    smooth = %s\n" (Signal_function.expression s 2 ty Type.Float)
  in
  let paced =
    if chance random 2 then ""
    else
      let least = Scope.fresh s.values "p" in
      let s = { s with values = Scope.bind [ (least, Type.Float) ] s.values } in
      f "    paced %s = %s\n" least (Signal_function.expression s 2 ty (Type.event ty))
  in
  f "instance Measured %s where\n    size %s = %s\n%s%s\ninstance Renewed %s where\n%s%s\n" head
    size_text
    (Expression.expression (Scope.bind bound s.values) 3 Float)
    (given "bigger" [ ty; ty ] Bool)
    smooth head
    (f "    next %s\n"
       (let text, bound = Pattern.any s.values ty in
        f "%s = %s" text (Expression.expression (Scope.bind bound s.values) 3 ty)))
    paced
