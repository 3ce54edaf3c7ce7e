open Basis
open Typing
open Diagnostic

(* Maximum length of a chain of names to follow. *)
let deepest = 6
let is_one u = Units.equal u Units.one

(* The function that an application applies. *)
let rec applied (e : Resolve.Ir.expr) =
  match e.desc with Apply { head; style = Juxtaposed; _ } -> applied head | _ -> e

let all_of results =
  if List.mem None results then None else Some (List.concat (List.filter_map Fun.id results))

(* The nonzero numbers that this choice can select; [None] if it can select anything other than a
   number. *)
let rec numbers words depth (e : Resolve.Ir.expr) : Bare_number.t list option =
  let right (r : Resolve.Ir.right) =
    all_of (List.map (fun (g : Resolve.Ir.guarded) -> numbers words depth g.value) r.guards)
  in
  if depth > deepest then None
  else
    match (e.desc, Bare_number.literal words e) with
    | Number _, None -> Some []
    | _, Some { signature = Some _; _ } -> None
    | _, Some number -> Some [ number ]
    | Negate e, None -> numbers words depth e
    | If { then_; else_; _ }, None -> all_of (List.map (numbers words depth) [ then_; else_ ])
    | Case { branches; _ }, None ->
        all_of (List.map (fun (b : Resolve.Ir.branch) -> right b.right) branches)
    | (Local _ | Global _), None ->
        let value = Bare_number.value words e in
        if value == e then None else numbers words (depth + 1) value
    | Apply { style = Juxtaposed; _ }, None ->
        Option.bind
          (Bare_number.own_function words (applied e))
          (fun (b : Resolve.Ir.binding) ->
            all_of
              (List.map
                 (fun (g : Resolve.Ir.guarded) -> numbers words (depth + 1) g.value)
                 b.body.guards))
    | _ -> None

let has_unit words u (number : Bare_number.t) =
  match number.unit_ with
  | None -> is_one u
  | Some written -> (
      match Wording.unit_written words written with Some v -> Units.equal u v | None -> false)

let distinct (numbers : Bare_number.t list) =
  let add found (n : Bare_number.t) =
    if List.exists (fun (m : Bare_number.t) -> Span.compare m.at n.at = 0) found then found
    else n :: found
  in
  List.rev (List.fold_left add [] numbers)

let angle (number : Bare_number.t) =
  match number.unit_ with
  | Some { factors = [ (Declared { name = ("deg" | "rad") as name; _ }, _) ]; _ } -> Some name
  | Some _ | None -> None

(* The unit to write after these numbers. *)
let unit_for words ~given ~wanted numbers =
  match Wording.measure words wanted with
  | "1/s" when is_one given ->
      Option.fold (angle (List.hd numbers)) ~none:"deg/s" ~some:(fun angle -> angle ^ "/s")
  | "1/s" -> "rad/s"
  | measure -> measure

(* Labels the numbers, and suggests this unit for them. *)
let give words ~given ~wanted ~where numbers d =
  let unit_ = unit_for words ~given ~wanted numbers in
  let literal (n : Bare_number.t) =
    if is_one wanted then n.digits else Printf.sprintf "%s[%s]" n.digits unit_
  in
  let text (n : Bare_number.t) = (if n.negative then "-" else "") ^ literal n in
  let what =
    if is_one given then "lacks the unit"
    else Printf.sprintf "is in `%s`" (Wording.measure words given)
  in
  let label d (n : Bare_number.t) =
    label ~at:n.at "%s"
      (match n.name with
      | Some name -> Printf.sprintf "`%s` is defined as this number, which %s" name what
      | None -> "this number " ^ what)
      d
  in
  let texts = Enumeration.all (List.map (fun n -> Printf.sprintf "`%s`" (text n)) numbers) in
  let if_meant =
    if is_one wanted then ""
    else if is_one given then " if that is the right unit"
    else " if you meant that unit"
  in
  List.fold_left label d numbers
  |> hint "write %s%s%s" texts where if_meant
  |> fix (Printf.sprintf "write %s" texts)
       (List.map (fun (n : Bare_number.t) -> (n.at, literal n)) numbers)

let chosen words ~subject ~expected (wanted, given) =
  let of_side ((e : Resolve.Ir.expr), (wanted, given)) =
    match if Bare_number.literal words e = None then numbers words 0 e else None with
    | Some (_ :: _ as all) when List.for_all (has_unit words given) all ->
        Some (give words ~given ~wanted ~where:"" (distinct all))
    | Some _ | None -> None
  in
  if Units.is_open wanted || Units.is_open given then None
  else List.find_map of_side (Lacking_unit_mistake.sides words ~subject ~expected (wanted, given))

let scaled words (e : Resolve.Ir.expr) (wanted, given) =
  match Bare_number.written_factor words e with
  | [ (number, 1) ]
    when number.unit_ <> None && has_unit words given number
         && not (is_one given || is_one wanted || Units.is_open wanted || Units.is_open given) ->
      Some (give words ~given ~wanted ~where:"" [ number ])
  | _ -> None

(* The numbers that the variable is compared with or added to in the expressions that [visit]
   visits. *)
let beside words (x : Resolve.Ir.Local.t) visit =
  let found = ref [] in
  let rec is_it (e : Resolve.Ir.expr) =
    match e.desc with
    | Local y -> y.id = x.id
    | Negate e | Apply { head = { desc = Global { name = "abs"; _ }; _ }; argument = e; _ } ->
        is_it e
    | _ -> false
  in
  let add e = Option.iter (fun n -> found := n :: !found) (Bare_number.literal words e) in
  let pair a b = if is_it a then add b else if is_it b then add a in
  let rec visitor : Resolve.Walk.visitor =
    { expr; pattern = ignore; binding = (fun b -> Resolve.Walk.binding visitor b) }
  and expr (e : Resolve.Ir.expr) =
    (match (Formula.binary e, e.desc) with
    | Some (("<" | "<=" | ">" | ">=" | "==" | "/=" | "+" | "-"), a, b), _ -> pair a b
    | ( None,
        Apply
          {
            head =
              {
                desc =
                  Apply { head = { desc = Global { name = "min" | "max"; _ }; _ }; argument = a; _ };
                _;
              };
            argument = b;
            _;
          } ) ->
        pair a b
    | _ -> ());
    Resolve.Walk.expr visitor e
  in
  visit visitor;
  List.rev !found

(* The variable of the parameter at this position, and a function that visits the definition that
   binds it. The parameter may also be the input of a `proc`. *)
let parameter words (f : Resolve.Ir.expr) position =
  let bound (p : Resolve.Ir.pattern) = match p.desc with Bound x -> Some x | _ -> None in
  let of_value (value : Resolve.Ir.expr) =
    match value.desc with
    | Proc { input; _ } when position = 1 ->
        Option.map (fun x -> (x, fun v -> Resolve.Walk.expr v value)) (bound input)
    | _ -> None
  in
  match Bare_number.own_function words f with
  | Some b ->
      Option.bind
        (List.nth_opt b.parameters (position - 1))
        (fun p -> Option.map (fun x -> (x, fun v -> Resolve.Walk.binding v b)) (bound p))
  | None -> (
      match Bare_number.value words f with value when value == f -> None | value -> of_value value)

let compared words ~(expected : Expected.t) (wanted, given) =
  match expected.because with
  | Parameter { head = Some f; callee = Some name; position; _ }
    when not (Units.is_open wanted || Units.is_open given || is_one given) -> (
      match parameter words f position with
      | None -> None
      | Some (x, visit) -> (
          match List.filter (has_unit words wanted) (beside words x visit) with
          | [] -> None
          | numbers ->
              let where = Printf.sprintf " in the definition of `%s`" name in
              Some (give words ~given:wanted ~wanted:given ~where (distinct numbers))))
  | _ -> None
