let size = Bias.alike
let rows = 25
let most_judges = 2

type failure = {
  number : int;
  recordings : Recording.t list;
  outcome : Engines.outcome;
  text : string;
  real : Basis.Real.t;
}

let summary ~seed { number; outcome; real; _ } =
  let precision = match real with Double -> "" | Single -> " in single precision" in
  Printf.sprintf "program %d of seed %d%s %s" number seed precision (Engines.describe outcome)

let describe ~seed failure =
  let recording =
    match failure.outcome with
    | Differ { recording; _ } -> "\n\nits input:\n\n" ^ Recording.csv recording
    | Agree | Rejected _ | Failed _ -> ""
  in
  Printf.sprintf "%s\n\n%s%s\n" (summary ~seed failure) (String.trim failure.text) recording

let write path text =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> output_string channel text)

(* {1 Tests and trials in the program} *)

(* Checks that the program's C is the same, byte for byte, without its tests: hosts do not need
   them. *)
let change_nothing tools file subject without : Engines.outcome =
  write file without;
  match Engines.load tools ~entry:"main" file with
  | Error outcome -> outcome
  | Ok plain when Engines.files plain = Engines.files subject -> Agree
  | Ok _ -> Failed "without its tests its C is another"

(* Compares the engines on the judges of the program's tests, which are ordinary programs. *)
let judge_alike random tools file : Engines.outcome =
  let of_entry so_far entry : Engines.outcome =
    if so_far <> Engines.Agree then so_far
    else
      let outcome =
        match Engines.load tools ~entry file with
        | Error outcome -> outcome
        | Ok subject ->
            Engines.judge tools [ Tcc ] subject (Engines.recordings random ~rows subject)
      in
      match outcome with
      | Agree -> Agree
      | other -> Failed (Printf.sprintf "`%s` %s" entry (Engines.describe other))
  in
  match Engines.judges tools file with
  | Error outcome -> outcome
  | Ok entries ->
      List.fold_left of_entry Engines.Agree (List.filteri (fun k _ -> k < most_judges) entries)

(* {1 Batches} *)

(* Generates and judges programs. A program judged alone gets the same input as its batch. *)
let on_input_of ?seen batch (tools : Engines.tools) engines ~seed ~first ~count =
  let make with_tests =
    Constant.in_range tools.real (Program.make ?seen ~sees:true ~with_tests ~seed ~first ~count ())
  in
  let text = make true in
  let file = Filename.concat tools.folder "program.frob" in
  write file text;
  let random = Random.State.make [| seed; batch; 1 |] in
  let tried subject : Engines.outcome =
    if not (Program.is_tried first) then Agree
    else
      match judge_alike random tools file with
      | Agree -> change_nothing tools file subject (make false)
      | other -> other
  in
  let outcome, recordings =
    match Engines.load tools ~entry:"main" file with
    | Error outcome -> (outcome, [])
    | Ok subject -> (
        let recordings = Engines.recordings random ~rows subject in
        (* Small programs take so little time that all of them also run with arbitrary dt. *)
        let is_short = (Bias.of_program ~seed first).root <> Any in
        let recordings =
          if Choice.chance random 3 || is_short then
            recordings @ [ Engines.with_dt random ~rows tools subject ]
          else recordings
        in
        match Engines.judge tools engines subject recordings with
        | Agree -> (tried subject, recordings)
        | other -> (other, recordings))
  in
  match outcome with
  | Agree -> None
  | Rejected _ | Failed _ | Differ _ ->
      Some { number = first; recordings; outcome; text; real = tools.real }

let patience = 60.

let shrunk (tools : Engines.tools) engines ~seed { number; recordings; outcome; text; real } =
  let components = List.init (Program.signals ~seed number) Fun.id in
  let small =
    Shrink.program tools engines ~seconds:patience
      ~first:
        (List.map
           (fun component -> Constant.in_range real (Program.alone ~seed number ~component))
           components)
      { text; outcome; recordings }
  in
  let outcome : Engines.outcome =
    match (small.outcome, small.recordings) with
    | Differ found, [ recording ] -> Differ { found with recording }
    | outcome, _ -> outcome
  in
  { number; recordings = small.recordings; outcome; text = small.text; real }

(* Whether the programs of this batch are compiled one by one. A program that is compiled alone
   is the root of the whole program, which tests other paths of the compiler. Compilers other
   than tcc are too slow for that. *)
let is_one_by_one (engines : Engines.c_engine list) ~seed first =
  let batch = first / size in
  let is_short =
    match (Bias.of_program ~seed first).root with
    | Small -> true
    | Cascade | Handed_on | Errand -> batch / Bias.count mod 2 = 0
    | Any -> false
  in
  engines = [ Tcc ] && (is_short || batch mod 8 = 7)

let failures ?seen tools engines ~seed ~first ~count =
  let alone ?seen i = on_input_of ?seen first tools engines ~seed ~first:(first + i) ~count:1 in
  if is_one_by_one engines ~seed first then List.filter_map (alone ?seen) (List.init count Fun.id)
  else
    match on_input_of ?seen first tools engines ~seed ~first ~count with
    | None -> []
    | Some whole -> (
        match List.filter_map (fun i -> alone i) (List.init count Fun.id) with
        | [] -> [ whole ]
        | failures -> failures)

let first_failure ?seen tools engines ~seed ~first ~count =
  if is_one_by_one engines ~seed first then
    List.find_map
      (fun i -> on_input_of ?seen first tools engines ~seed ~first:(first + i) ~count:1)
      (List.init count Fun.id)
  else on_input_of ?seen first tools engines ~seed ~first ~count
