open Choice

let f = Printf.sprintf

let input_type : Type.t =
  Tuple
    [
      Float; Int; Bool; Type.event Float; Type.maybe (Tuple [ Int; Bool ]); Float; Array (3, Float);
      Measure { metres = 1; seconds = 0 };
    ]

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
      Scope.random;
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
    if k = 0 then s
    else functions (k - 1) (add (Definition.function_ s (Scope.fresh values "f")))
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
              ~result:(Computed (any ())) name))
  in
  let s = { Signal_function.values; known = [] } in
  List.iter (fun ty -> Buffer.add_string out (Definition.instances s ty)) (List.rev declared);
  let s = functions (Random.State.int random 3) { s with values = { values with methods = true } } in
  let s = signal_functions (Random.State.int random 3) s in
  let s = if chance random (if bias.switches > 5 then 1 else 2) then add (Definition.modes s) else s in
  let s = if chance random (if bias.tasks > 1 then 2 else 5) then add (Definition.tasks s) else s in
  let signals = Signal_function.any_signals s in
  ignore
    (add
       (Definition.signal_function s ~parameters:[] ~input:input_type ~signals ~result:All_signals
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
  String.concat "" ((Shared.text :: texts) @ [ main ])

let signals ~seed number =
  let _, _, signals = one ~seen:(Coverage.create ()) ~seed number in
  List.length signals

let alone ~seed number ~component =
  let name, text, signals = one ~seen:(Coverage.create ()) ~seed number in
  let pattern = List.mapi (fun i _ -> if i = component then "y" else "_") signals in
  Shared.text ^ text
  ^ main
      ~output:(Type.text (List.nth signals component))
      (f "y where\n    (%s) = %s i" (String.concat ", " pattern) name)
