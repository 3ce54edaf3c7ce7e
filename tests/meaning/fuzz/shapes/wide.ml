open Choice

let f = Printf.sprintf
let output : Type.t = Tuple [ Int; Float; Bool ]

(* Joins all names in one expression. *)
let joined random operators names =
  let join text x = f "(%s %s %s)" text (one_of random operators) x in
  List.fold_left join (List.hd names) (List.tl names)

let definition (values : Scope.t) name =
  let random = values.random in
  (* Tuples cannot have that many components, so they are nested. *)
  let groups =
    List.init
      (7 + Random.State.int random 3)
      (fun _ ->
        let one (ty : Type.t) = (Scope.fresh values "u", ty) in
        [
          one Int;
          one Float;
          one Bool;
          one (one_of random [ Type.Int; Float; Bool ]);
          one Type.Float;
        ])
  in
  let input = Type.Tuple (List.map (fun group -> Type.Tuple (List.map snd group)) groups) in
  let tuple names = f "(%s)" (String.concat ", " names) in
  let pattern = tuple (List.map (fun group -> tuple (List.map fst group)) groups) in
  let all ty =
    List.filter_map (fun (x, t) -> if t = ty then Some x else None) (List.concat groups)
  in
  let number = joined random [ "+"; "-"; "*"; "`min`" ] (shuffled random (all Int)) in
  let float = joined random [ "+"; "-"; "`max`" ] (shuffled random (all Float)) in
  let truth = joined random [ "&&"; "||"; "/=" ] (shuffled random (all Bool)) in
  (* Adds a state, or a function. *)
  let number = if chance random 2 then number else f "delay 0 %s" number in
  let truth = if chance random 2 then truth else f "%s /= (%s > 2)" truth (List.hd (all Int)) in
  Scope.note values "wide function";
  ( f "%s :: SF %s %s\n%s = proc %s -> (%s, %s, %s)\n\n" name (Type.text input) (Type.text output)
      name pattern number float truth,
    input )

let part (values : Scope.t) (ty : Type.t) ~call =
  let x = Scope.fresh values "x" in
  match ty with
  | Int -> Some (f "(let (%s, _, _) = %s in %s)" x call x)
  | Float -> Some (f "(let (_, %s, _) = %s in %s)" x call x)
  | Bool -> Some (f "(let (%s, _, %s') = %s in %s' && %s > 0)" x x call x x)
  | _ when ty = output -> Some call
  | Measure _ | Tuple _ | Array _ | Data _ -> None
