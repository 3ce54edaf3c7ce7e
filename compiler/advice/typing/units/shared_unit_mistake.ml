open Basis
open Typing
open Diagnostic

(* The exponent of the only unit variable in a parameter's declared type, which may be an event or
   an array of numbers. *)
let rec exponent (t : Type.t) =
  match Type.expand t with
  | Rigid _ | Flexible _ -> Some Rational.one
  | Data { arguments = _ :: _ as arguments; _ } ->
      exponent (List.nth arguments (List.length arguments - 1))
  | Function (parameter, _) -> exponent parameter
  | Number (_, u) -> (
      match Units.rigid_powers u with [ (_, power) ] -> Some power | _ :: _ :: _ | [] -> None)
  | _ -> None

let rec parameters (t : Type.t) =
  match Type.expand t with
  | Function (parameter, result) -> parameter :: parameters result
  | Signal_function (input, _) -> [ input ]
  | _ -> []

(* The parameter types in the function's signature, or an empty list if it has no signature. *)
let declared words (head : Resolve.Ir.expr option) =
  match head with
  | Some { desc = Global g; _ } ->
      Option.fold (Wording.declared_type words g) ~none:[] ~some:parameters
  | Some _ | None -> []

(* The argument at [position] has the unit [given] instead of [wanted]. Returns the unit that the
   argument at [place] would need to correct the mismatch. *)
let unit_for words head ~place ~position ~current (wanted, given) =
  let of_parameter i =
    match declared words head with
    | [] -> Some Rational.one
    | types -> Option.bind (List.nth_opt types i) exponent
  in
  match (of_parameter place, of_parameter (position - 1)) with
  | Some a, Some b when not (Rational.is_zero b) ->
      let factor = Rational.multiply a (Rational.inverse b) in
      Some (Units.multiply current (Units.power (Units.divide given wanted) factor))
  | _ -> None

type suspect = { number : Bare_number.t; position : int; current : Units.t; unit_ : Units.t }

let is_earlier (decided : Expected.decider list) (e : Resolve.Ir.expr) =
  List.exists (fun (d : Expected.decider) -> Span.compare d.place e.span = 0) decided

let unit_of (t : Type.t) = match Type.expand t with Number (_, u) -> Some u | _ -> None
let is_function (t : Type.t) = match Type.expand t with Function _ -> true | _ -> false

(* A function that accepts any unit, such as `min`. *)
let is_general words (e : Resolve.Ir.expr) =
  match e.desc with
  | Global g -> (
      match Option.map Type.expand (Wording.declared_type words g) with
      | Some (Function (parameter, _)) -> exponent parameter <> None
      | _ -> false)
  | _ -> false

(* The numbers without a unit in a function such as `(< 0.5)`. *)
let rec within words (e : Resolve.Ir.expr) =
  match e.desc with
  | Number { unit_ = None; _ } -> Option.to_list (Bare_number.literal words e)
  | Apply { head; argument; style = Operator _ } -> within words head @ within words argument
  | Apply { head; argument; _ } -> within words head @ within words argument
  | Lambda { body; _ } -> within words body
  | _ -> []

(* The earlier arguments that are number literals and contribute to the unit. *)
let suspects words ~head ~given ~decided ~position units =
  let decided_by_a_function =
    List.exists (fun e -> is_general words e && is_earlier decided e) given
  in
  let suspect i (e : Resolve.Ir.expr) =
    let decider =
      List.find_opt (fun (d : Expected.decider) -> Span.compare d.place e.span = 0) decided
    in
    let literal =
      match Bare_number.literal words e with
      | Some number -> Some number
      | None -> ( match within words e with [ number ] -> Some number | _ -> None)
    in
    match (literal, decider) with
    | Some ({ unit_ = None; _ } as number), None when i < position - 1 && decided_by_a_function ->
        Some
          {
            number;
            position = i + 1;
            current = Units.one;
            unit_ = Units.divide (snd units) (fst units);
          }
    | Some number, Some { decides; _ }
      when number.unit_ = None && i < position - 1 && is_function decides ->
        Option.map
          (fun unit_ -> { number; position = i + 1; current = Units.one; unit_ })
          (unit_for words head ~place:i ~position ~current:Units.one units)
    | Some number, Some { decides; _ } when i < position - 1 -> (
        match unit_of decides with
        | Some current when not (Units.is_open current) ->
            Option.map
              (fun unit_ -> { number; position = i + 1; current; unit_ })
              (unit_for words head ~place:i ~position ~current units)
        | Some _ | None -> None)
    | _ -> None
  in
  List.filter_map Fun.id (List.mapi suspect given)

(* Does another earlier argument also determine the unit? A zero does not. *)
let has_other_reason words ~given ~decided =
  let is_zero (e : Resolve.Ir.expr) =
    match e.desc with Number { digits; _ } -> float_of_string_opt digits = Some 0. | _ -> false
  in
  List.exists
    (fun e ->
      is_earlier decided e
      && Bare_number.literal words e = None
      && within words e = []
      && not (is_zero e || is_general words e))
    given

(* The unit as written in a program, including the unit of an angle. Empty if there is no unit. *)
let written words (number : Bare_number.t) unit_ =
  let angle =
    match number.unit_ with
    | Some { factors = (Declared { name = ("deg" | "rad") as name; _ }, _) :: _; _ } -> Some name
    | Some _ | None -> None
  in
  match (angle, Wording.measure words unit_) with
  | Some angle, "1" -> angle
  | Some angle, "1/s" -> angle ^ "/s"
  | None, "1" -> ""
  | _, measure -> measure

let give words { number; unit_; _ } d =
  match (number.unit_, number.name) with
  | None, _ -> Bare_number.give words number (Wording.measure words unit_) d
  | Some _, name -> (
      let sign = if number.negative then "-" else "" in
      let text =
        match written words number unit_ with
        | "" -> number.digits
        | unit_ -> Printf.sprintf "%s[%s]" number.digits unit_
      in
      match name with
      | None ->
          hint "%s"
            (if String.equal text number.digits then
               Printf.sprintf "write `%s%s`, without a unit" sign text
             else Printf.sprintf "write `%s%s` if you meant that unit" sign text)
            d
          |> write number.at text
      | Some name ->
          label ~at:number.at "`%s` is defined as this number" name d
          |>
          if number.signature = None then fun d ->
            hint "if `%s` has the wrong unit, write `%s = %s%s`" name name sign text d
            |> write number.at text
          else Fun.id)

(* In `min 0.3[m/s] (d - 0.4[m])`, a missing gain is more likely than a wrong unit. *)
let gain words ~(subject : Resolve.Ir.expr) { number; current; unit_; _ } =
  match (number, Wording.quote words subject.span) with
  | { unit_ = Some _; name = None; _ }, Some text
    when String.equal (Wording.measure words (Units.divide current unit_)) "1/s"
         && not (Units.equal unit_ Units.one) ->
      hint "to convert `%s` to `%s`, multiply by a gain, as in `0.5[1/s] * %s`"
        (Wording.measure words unit_) (Wording.measure words current) (Source.grouped text)
  | _ -> Fun.id

let report words ~callee ~(subject : Resolve.Ir.expr) ~found ~at (first, rest) =
  let text = Wording.measure words in
  let error format = error ~code:"E0320" ~at format in
  let d =
    if Units.equal first.current Units.one then
      error "expected the unit `%s`, found none" (text first.unit_)
    else if Units.equal first.unit_ Units.one then
      error "expected no unit, found `%s`" (text first.current)
    else error "expected the unit `%s`, found `%s`" (text first.unit_) (text first.current)
  in
  d
  |> here "argument %d of `%s`" first.position callee
  |> label ~at:subject.span "because this is %s, and `%s` needs matching units"
       (Wording.described words found) callee
  |> fun d ->
  let all = first :: rest in
  let is_bare { number; _ } = number.unit_ = None && number.name = None in
  if rest <> [] && List.for_all is_bare all then
    Bare_number.give_literals
      (List.map (fun { number; unit_; _ } -> (number, Wording.measure words unit_)) all)
      d
  else
    let d = if rest = [] then gain words ~subject first d else d in
    List.fold_left (fun d suspect -> give words suspect d) d all

(* Does an input among the later arguments have this unit too? *)
let agrees_with_a_later words ~given ~position unit_ =
  let agrees i (e : Resolve.Ir.expr) =
    i >= position
    &&
    match e.desc with
    | Local x -> (
        match Option.bind (List.assoc_opt x.name (Wording.inputs words)) unit_of with
        | Some u -> Units.equal u unit_
        | None -> false)
    | _ -> false
  in
  List.exists Fun.id (List.mapi agrees given)

(* `delay 0.5[s] v`, meant to delay `v` by 0.5 s. *)
let is_a_time words ~callee { number; current; _ } =
  String.equal callee "delay" && number.unit_ <> None
  && String.equal (Wording.measure words current) "s"

(* Reports a constant in the argument [e] that lacks a unit. With that unit, the argument would be
   correct. Numbers with units among the other arguments are assumed to be right. *)
let of_a_constant words ~callee ~(subject : Resolve.Ir.expr) ~found ~place (e : Resolve.Ir.expr)
    ~current unit_ constants =
  let text = Wording.measure words in
  let error format = error ~code:"E0320" ~at:e.span format in
  let d =
    if Units.equal current Units.one then error "expected the unit `%s`, found none" (text unit_)
    else error "expected the unit `%s`, found `%s`" (text unit_) (text current)
  in
  let give d (number, power) =
    let needed = Units.power (Units.divide unit_ current) (Rational.of_int power) in
    Bare_number.give words number (text needed) d
  in
  d
  |> here "argument %d of `%s`" place callee
  |> label ~at:subject.span "because this is %s, and `%s` needs matching units"
       (Wording.described words found) callee
  |> fun d -> List.fold_left give d constants

(* A product with a constant that lacks its unit, as an argument before a number that has one: `min
   (kp * d) 0.4[m/s]`. *)
let of_an_earlier_constant words ~head ~callee ~given ~decided ~position ~subject ~found units =
  let constants i (e : Resolve.Ir.expr) =
    let decider =
      List.find_opt (fun (d : Expected.decider) -> Span.compare d.place e.span = 0) decided
    in
    match
      ( Option.bind decider (fun (d : Expected.decider) -> unit_of d.decides),
        Bare_number.literal words e )
    with
    | Some current, None when not (Units.is_open current) -> (
        match
          (Bare_number.factor words e, unit_for words head ~place:i ~position ~current units)
        with
        | (_ :: _ as constants), Some unit_ ->
            Some
              (of_a_constant words ~callee ~subject ~found ~place:(i + 1) e ~current unit_ constants)
        | _ -> None)
    | _ -> None
  in
  List.mapi constants given |> List.find_map Fun.id

(* Is this argument wrong, rather than the earlier numbers whose unit it does not match? *)
let is_to_blame words ~(subject : Resolve.Ir.expr) (wanted, given) =
  Formula_mistake.is_of_square words ~subject:(Some subject) (wanted, given)
  || (not (String.equal (Wording.measure words (Units.divide wanted given)) "s"))
     && (Lacking_unit_mistake.scaled words subject <> []
        ||
        match Bare_number.written_factor words subject with
        | [ ({ unit_ = None; digits; _ }, _) ] ->
            Bare_number.literal words subject = None
            && (String.contains digits '.'
               || String.starts_with ~prefix:"1/"
                    (Wording.measure words (Units.divide wanted given)))
        | _ -> false)

let is_number_with_unit words (e : Resolve.Ir.expr) =
  match Bare_number.literal words e with Some { unit_ = Some _; _ } -> true | _ -> false

let of_a_number words ~(expected : Expected.t) ~found ~subject (wanted, given) =
  match (expected.because, subject) with
  | ( Parameter { callee = Some callee; head; given = arguments; position; decided_by; _ },
      Some (subject : Resolve.Ir.expr) )
    when decided_by <> []
         && (not (Units.is_open wanted || Units.is_open given))
         && not (has_other_reason words ~given:arguments ~decided:decided_by) -> (
      let all =
        suspects words ~head ~given:arguments ~decided:decided_by ~position (wanted, given)
      in
      let bare = List.filter (fun s -> s.number.unit_ = None) all in
      let itself = Bare_number.literal words subject in
      match ((if bare <> [] then bare else all), itself) with
      | [], _ -> None
      | _ when bare = [] && is_to_blame words ~subject (wanted, given) -> None
      | _
        when bare = []
             && Wrong_unit_mistake.gain words ~subject:(Some subject) ~expected (wanted, given)
                <> None ->
          None
      (* either of two numbers with units may be wrong *)
      | _, Some { unit_ = None; _ } -> None
      | _, Some _ when bare = [] && not (agrees_with_a_later words ~given:arguments ~position given)
        ->
          None
      | first :: _, _ when is_a_time words ~callee first -> None
      | first :: rest, _ ->
          let at =
            match List.nth_opt arguments (first.position - 1) with
            | Some e when Bare_number.literal words e <> None -> e.span
            | Some _ | None -> first.number.at
          in
          Some (report words ~callee ~subject ~found ~at (first, rest)))
  | _ -> None

let of_an_earlier_number words ~(expected : Expected.t) ~found ~subject units =
  let constant =
    match (expected.because, subject) with
    | ( Parameter { callee = Some callee; head; given; position; decided_by = decided; _ },
        Some subject )
      when is_number_with_unit words subject
           && not (Units.is_open (fst units) || Units.is_open (snd units)) ->
        of_an_earlier_constant words ~head ~callee ~given ~decided ~position ~subject ~found units
    | _ -> None
  in
  match constant with
  | Some diagnostic -> Some diagnostic
  | None -> of_a_number words ~expected ~found ~subject units
