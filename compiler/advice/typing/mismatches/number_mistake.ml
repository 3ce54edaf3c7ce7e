open Basis
open Typing
open Diagnostic

(* {1 Units} *)

(* The angle unit, `deg` or `rad`, if the literal has exactly that unit. Types do not show it,
   because angles are dimensionless. *)
let angle : Resolve.Ir.unit_ option -> string option = function
  | Some { factors = [ (Declared { name = ("deg" | "rad") as name; _ }, _) ]; _ } -> Some name
  | Some _ | None -> None

let is_angular_velocity (t : Type.t) =
  match Type.repr t with Alias { alias = { name = "AngularVelocity"; _ }; _ } -> true | _ -> false

(* A time without a unit is probably in seconds if it is less than [many_seconds], and in
   milliseconds if it is at least [many_milliseconds]. *)
let many_seconds = 20.
let many_milliseconds = 100.

let with_unit words ~(expected : Expected.t) ~at digits unit_ =
  let text = Wording.measure words unit_ in
  let with_fix words units d =
    let with_unit unit_ = write at (Printf.sprintf "%s[%s]" digits unit_) in
    List.fold_right with_unit (List.rev units) (hint "%s" words d)
  in
  let is_at_least least =
    Option.fold (float_of_string_opt digits) ~none:false ~some:(( <= ) least)
  in
  let is_a_field = match expected.because with Field _ -> true | _ -> false in
  if is_angular_velocity expected.ty then
    with_fix
      (Printf.sprintf
         "write `%s[deg/s]` for degrees per second, or `%s[rad/s]` for radians per second" digits
         digits)
      [ "deg/s"; "rad/s" ]
  else if
    String.equal text "s" && is_at_least many_seconds
    && (is_a_field || not (is_at_least many_milliseconds))
  then
    with_fix
      (Printf.sprintf "write `%s[s]` if these are seconds, or `%s[ms]` if these are milliseconds"
         digits digits)
      [ "s"; "ms" ]
  else if String.equal text "s" && is_at_least many_seconds then
    with_fix
      (Printf.sprintf "write `%s[ms]` if these are milliseconds, or `%s[s]` if these are seconds"
         digits digits)
      [ "ms"; "s" ]
  else with_fix (Printf.sprintf "write `%s[%s]` if that is the right unit" digits text) [ text ]

(* The number literals that an expression chooses from. Omits zero, because zero can have any
   unit. *)
let rec chosen (e : Resolve.Ir.expr) =
  match e.desc with
  | Number { digits; _ } when float_of_string_opt digits = Some 0. -> []
  | Number { digits; unit_; _ } -> [ (digits, unit_, e.span) ]
  | Negate e -> chosen e
  | If { then_; else_; _ } -> chosen then_ @ chosen else_
  | Case { branches; _ } ->
      let of_guard (g : Resolve.Ir.guarded) = chosen g.value in
      List.concat_map
        (fun (b : Resolve.Ir.branch) -> List.concat_map of_guard b.right.guards)
        branches
  | _ -> []

(* The number literal, if the expression is a literal or a name that is defined as a literal. *)
let literal words (e : Resolve.Ir.expr) =
  match e.desc with
  | Local x -> (
      match Option.fold (Wording.definition words x) ~none:[] ~some:chosen with
      | [ (digits, unit_, at) ] ->
          Some
            {
              Bare_number.digits;
              negative = false;
              unit_;
              at;
              name = Some x.name;
              signature = None;
              of_record = false;
            }
      | _ -> None)
  | Negate _ -> None
  | _ -> Bare_number.literal words e

(* A number literal without a unit where a number with a unit is expected. *)
let unit_of_literal words ~subject ~(expected : Expected.t) ~found (wanted, given) diagnostic =
  let is_global (e : Resolve.Ir.expr option) =
    match e with Some { desc = Global _; _ } -> true | Some _ | None -> false
  in
  let write (e : Resolve.Ir.expr option) ~expected unit_ =
    match Option.bind e (literal words) with
    | Some ({ unit_ = None; _ } as number)
      when is_global e && Units.flexible_powers unit_ = [] && Units.rigid_powers unit_ = [] ->
        Some (Bare_number.give words number (Wording.measure words unit_), number.at, None)
    | Some { digits; unit_ = None; at; name; _ }
      when Units.flexible_powers unit_ = [] && Units.rigid_powers unit_ = [] ->
        Some (with_unit words ~expected ~at digits unit_, at, name)
    | Some { digits; unit_ = written; at; name; _ } when Unit_conversion.is_per_second words unit_
      ->
        let per_second angle =
          let text = Printf.sprintf "%s[%s/s]" digits angle in
          let with_fix d =
            hint "write `%s` if this is the turn rate" text d
            |> Diagnostic.write at text
            |> Option.value
                 (Unit_conversion.of_the_other_operand words ~expected (wanted, given))
                 ~default:Fun.id
          in
          (with_fix, at, name)
        in
        Option.map per_second (angle written)
    | _ -> None
  in
  let other = match expected.because with Operand { other; _ } -> Some other | _ -> None in
  let is_one u = Units.equal u Units.one in
  let with_fix =
    if is_one given then write subject ~expected wanted
    else if is_one wanted then write other ~expected:{ expected with ty = found } given
    else None
  in
  match with_fix with
  | None -> diagnostic
  | Some (with_fix, _, None) -> with_fix diagnostic
  | Some (with_fix, at, Some name) ->
      label ~at "`%s` is defined as this number" name diagnostic |> with_fix

(* `Float` without brackets in a signature, where a quantity was meant. *)
let without_brackets words (wanted, given) diagnostic =
  let write u =
    hint "use `Float[%s]` for this unit; without brackets, `Float` and `Double` have no unit"
      (Wording.measure words u) diagnostic
  in
  if Units.equal given Units.one && not (Units.is_open wanted) then write wanted
  else if Units.equal wanted Units.one && not (Units.is_open given) then write given
  else diagnostic

(* A delay by a time, as in Yampa's [delay q]. *)
let by_time words ~(expected : Expected.t) diagnostic =
  match expected.because with
  | Parameter { callee = Some "delay"; position = 2; given = [ time; signal ]; _ }
    when Option.fold (Bare_number.literal words time) ~none:false ~some:(fun n ->
             n.Bare_number.unit_ <> None) -> (
      let explained =
        hint
          "`delay x0` delays by one instant, not by a fixed time; `x0` is its output at the first \
           instant"
      in
      match (Wording.quote words time.span, Wording.quote words signal.span) with
      | Some time, Some signal ->
          hint
            "to delay by a fixed time, write `delayBy %s %s`, with `import Control`; `delay x0` \
             delays by one instant, and `x0` is its output at the first instant"
            time (Source.grouped signal) diagnostic
      | _ -> explained diagnostic)
  | Parameter { callee = Some "delay"; position = 2; _ } ->
      hint
        "`delay x0` delays by one instant, not by a fixed time; `x0` is its output at the first \
         instant"
        diagnostic
  | _ -> diagnostic

(* Does the unit have only integer exponents? *)
let is_whole u = List.for_all (fun (_, power) -> Rational.is_integer power) (Units.base_powers u)

(* A decimal literal without a unit among the factors, if there is one. *)
let rec plain_factor (e : Resolve.Ir.expr) =
  match e.desc with
  | Number { digits; unit_ = None; decimal = true } -> Some digits
  | Apply { head; argument; style = Operator _ | Juxtaposed } -> (
      match plain_factor argument with Some digits -> Some digits | None -> plain_factor head)
  | Negate e -> plain_factor e
  | _ -> None

let factor_without_unit words ~subject (wanted, given) diagnostic =
  match Option.bind subject plain_factor with
  | Some digits when diagnostic.hints = [] && not (Units.is_open wanted || Units.is_open given) ->
      hint "perhaps a number lacks its unit: if `%s` has no unit, the unit of the result is `%s`"
        digits (Wording.measure words given) diagnostic
  | _ -> diagnostic

(* The name of the signal function that the expression applies, if it applies one. *)
let rec runs words (e : Resolve.Ir.expr option) =
  match e with
  | Some { desc = Apply { head; style = Juxtaposed; _ }; _ } -> runs words (Some head)
  | Some { desc = Global g; _ } -> (
      match Wording.declared words g with
      | Some ty when List.mem "SF" (String.split_on_char ' ' ty) -> Some g.name
      | _ -> None)
  | _ -> None

(* The signature with its result type replaced by this type, if the result type is the expected
   type. *)
let corrected_signature words at (expected : Expected.t) found =
  let wanted = Wording.type_ words expected.ty and found = Wording.type_ words found in
  match Wording.quote words at with
  | Some text when String.ends_with ~suffix:(" " ^ wanted) text ->
      let before = String.sub text 0 (String.length text - String.length wanted) in
      Some (Source.with_opening (before ^ found))
  | Some text when String.equal text wanted -> Some found
  | Some _ | None -> None

type topic += Corrected_signature

let hint_for_signature words ~(expected : Expected.t) ~found d =
  match expected.because with
  | (Signature _ | Output (Signature _)) when List.mem Expected.Of_array expected.parts ->
      hint
        "if all elements of the array have this unit, write `%s` in the signature; if they have \
         different units, use a tuple here and in the signature"
        (Wording.type_ words found) d
  | Signature { at; name } | Output (Signature { at; name }) -> (
      match corrected_signature words at expected found with
      | Some text ->
          hint ~topic:Corrected_signature
            "if this is the right result, write the signature as `%s :: %s`" name text d
          |> write at text
      | None ->
          hint "if this is the right result, write `%s` in the signature"
            (Wording.type_ words found) d)
  | _ -> d

(* Suggests a different signature, because the result may be right and the signature wrong. *)
let signature_of_this words ~subject ~(expected : Expected.t) ~found (wanted, given) diagnostic =
  match expected.because with
  | Signature { name; _ } when runs words subject <> None && Wording.inputs words = [] ->
      hint
        "`%s` is a signal function: run it in a `proc`, as in `%s = proc x -> …`, with the type \
         `SF … …`"
        (Option.get (runs words subject))
        name diagnostic
  | (Signature _ | Output (Signature _))
    when (not (Units.is_open wanted || Units.is_open given || Units.equal given Units.one))
         && is_whole given ->
      hint_for_signature words ~expected ~found diagnostic
  | _ -> diagnostic

(* Does the expression apply named functions, and contain no number that could lack its unit? Then
   its unit follows from the functions alone, so the signature is the likely mistake. *)
let is_of_functions words e =
  let rec has_no_number (e : Resolve.Ir.expr) =
    match e.desc with
    | Local _ | Global _ -> Bare_number.literal words e = None
    | Apply { head; argument; _ } -> has_no_number head && has_no_number argument
    | Negate e | Field { record = e; _ } -> has_no_number e
    | _ -> false
  in
  let rec go followed (e : Resolve.Ir.expr) =
    match e.desc with
    | Apply { style = Juxtaposed; _ } -> has_no_number e
    | Local x when not (List.mem x.id followed) ->
        Option.fold (Wording.definition words x) ~none:false ~some:(go (x.id :: followed))
    | _ -> false
  in
  go [] e

(* [sqrt d], if the argument has the unit that the result should have. *)
let root words ~(subject : Resolve.Ir.expr option) (wanted, given) d =
  match subject with
  | Some { desc = Apply { head = { desc = Global { name = "sqrt"; _ }; _ }; argument; _ }; _ }
    when not (Units.equal wanted Units.one) ->
      (match Wording.quote words argument.span with
      | Some text when not (is_whole given) ->
          hint "to take the root of the number alone, write `sqrt (%s / 1[%s]) * 1[%s]`"
            (Source.grouped text)
            (Wording.measure words (Units.multiply given given))
            (Wording.measure words wanted) d
      | Some _ | None -> d)
      |> note "`sqrt` halves the exponents of the unit: for `%s`, its argument must be in `%s`"
           (Wording.measure words wanted)
           (Wording.measure words (Units.multiply wanted wanted))
  | _ -> d

(* Suggests a different signature first, if the definition is consistent on its own. *)
let against_signature words ~subject ~(expected : Expected.t) ~found (wanted, given) d =
  match (expected.because, subject) with
  | (Signature _ | Output (Signature _)), Some e
    when d.hints = []
         && (Wording.inputs words <> []
            || runs words (match expected.because with Signature _ -> subject | _ -> None) = None)
         && (is_of_functions words e
            || Formula.is_product words e
               && (not (Formula_mistake.is_of_square words ~subject (wanted, given)))
               && Formula_mistake.power words ~subject ~expected (wanted, given) = None)
         && not (Units.is_open wanted || Units.is_open given) ->
      let d = if is_whole given then hint_for_signature words ~expected ~found d else d in
      Some (root words ~subject (wanted, given) d)
  | _ -> None

(* A turn rate computed from another quantity without a gain. *)
let turn words ~subject ~(expected : Expected.t) (wanted, given) diagnostic =
  match subject with
  | Some (e : Resolve.Ir.expr)
    when diagnostic.hints = []
         && Unit_conversion.is_per_second words wanted
         && not (Unit_conversion.is_operand expected || Units.is_open given) -> (
      match Distant_number.scaled words e (wanted, given) with
      | Some complete -> complete diagnostic
      | None ->
          let text = Option.value (Wording.quote words e.span) ~default:"e" in
          hint "to convert `%s` to `1/s`, multiply by a gain, as in `2[%s] * %s`"
            (Wording.measure words given)
            (Wording.measure words (Units.divide wanted given))
            (Source.grouped text) diagnostic)
  | _ -> diagnostic

(* `n > 50[px]`, where the other operand has no unit. *)
let plain_number words ~(subject : Resolve.Ir.expr option) ~(expected : Expected.t) (wanted, given)
    d =
  match (expected.because, Option.bind subject (literal words)) with
  | Operand { other; other_type; _ }, Some { digits; unit_ = Some _; at; _ }
    when d.hints = [] && Units.equal wanted Units.one
         && String.equal (Wording.type_ words other_type) "Angle" ->
      let text = digits ^ "[rad]" in
      let name = Option.value (Wording.quote words other.span) ~default:"the other operand" in
      hint "`%s` is an angle: write `%s`" name text d |> write at text
  | Operand { other; _ }, Some { digits; unit_ = Some _; at; _ }
    when d.hints = [] && Units.equal wanted Units.one ->
      (match Wording.quote words other.span with
      | Some other -> hint "`%s` is a plain number: write `%s`" other digits d
      | None -> hint "write `%s` if you mean a plain number" digits d)
      |> write at digits
  | Parameter { callee = Some "turnBy"; head = Some head; _ }, Some { unit_ = Some _; _ }
    when d.hints = [] && Units.equal wanted Units.one
         && String.equal (Wording.measure words given) "m" ->
      hint "`turnBy` turns by an angle: to drive a distance, write `forward %s`"
        (Option.fold
           (Option.bind subject (fun (e : Resolve.Ir.expr) -> Wording.quote words e.span))
           ~none:"1[m]" ~some:Source.grouped)
        d
      |> write head.span "forward"
  | Parameter { callee = Some _; _ }, Some { digits; unit_ = Some _; name = None; negative; at; _ }
    when d.hints = [] && Units.equal wanted Units.one ->
      hint "write `%s%s`, without a unit, if it is a plain number"
        (if negative then "-" else "")
        digits d
      |> write at digits
  | _ -> d

(* `[integral v, v]`, where each element has a unit of its own. *)
let of_elements words ~(subject : Resolve.Ir.expr option) ~(expected : Expected.t) (wanted, given) =
  let has_unit u = not (Units.is_open u || Units.equal u Units.one) in
  match (expected.because, subject) with
  | Element first, Some e when has_unit wanted && has_unit given ->
      let stop = Span.forward 1 e.span.stop in
      let tuple =
        match Wording.quote words (Span.make ~file:first.file ~start:first.start ~stop) with
        | Some elements when String.ends_with ~suffix:"]" elements ->
            Printf.sprintf "a tuple, `(%s)`," (String.sub elements 0 (String.length elements - 1))
        | Some _ | None -> "a tuple"
      in
      let of_the_same = "all elements of an array have the same unit" in
      Some
        (match literal words e with
        | Some { digits; negative; _ } ->
            hint "%s: write `%s%s[%s]`, or, for elements with different units, %s or a record"
              of_the_same
              (if negative then "-" else "")
              digits (Wording.measure words wanted) tuple
        | None ->
            hint
              "%s: write %s or a record; for an array of plain numbers, divide each element by its \
               unit, as in `%s / 1[%s]`"
              of_the_same tuple
              (Option.fold (Wording.quote words e.span) ~none:"x" ~some:Source.grouped)
              (Wording.measure words given))
  | _ -> None

let first_of rules = List.find_map (fun rule -> rule ()) rules

(* The rules that make all other hints unnecessary. [is_first]: there is no hint yet. *)
let certain words ~subject ~expected ~is_first units =
  let operand = Unit_conversion.is_operand expected in
  first_of
    [
      (fun () -> Summed_rate.complete words ~subject ~expected units);
      (fun () -> Distant_number.compared words ~expected units);
      (fun () -> of_elements words ~subject ~expected units);
      (fun () ->
        if is_first && Units.equal (snd units) Units.one then
          Distant_number.chosen words ~subject ~expected units
        else None);
      (fun () -> Wrong_unit_mistake.superfluous_factor words ~subject ~expected units);
      (fun () -> Formula_edit.exchanged_angle words ~subject ~expected units);
      (fun () -> Formula_edit.suggest words ~elsewhere:true ~subject ~expected units);
      (fun () -> Function_unit_mistake.complete words ~subject ~expected units);
      (fun () -> if operand then Formula_mistake.root words ~subject ~expected units else None);
      (fun () -> Lacking_unit_mistake.gain_without_unit words ~subject ~expected units);
      (fun () ->
        if is_first then Lacking_unit_mistake.complete words ~subject ~expected units else None);
      (fun () -> Lacking_unit_mistake.of_a_difference words ~subject units);
      (fun () -> Formula_mistake.rate words ~subject ~expected units);
      (fun () -> if operand then None else Lacking_unit_mistake.of_the_inverse words ~subject units);
    ]

(* The rules that come before the hint for the signature. *)
let likely words ~subject ~expected units =
  first_of
    [
      (fun () ->
        if Unit_conversion.is_operand expected then None
        else Formula_mistake.root words ~subject ~expected units);
      (fun () -> Formula_mistake.within_root words ~subject units);
      (fun () -> Formula_mistake.rounded words ~subject units);
      (fun () -> Formula_mistake.rate_for_angle words ~subject units);
      (fun () -> Formula_mistake.gain_of_rate words ~subject ~expected units);
      (fun () -> Formula_mistake.upside_down words ~subject units);
      (fun () -> Formula_edit.of_a_field words ~subject ~expected units);
      (fun () -> Formula_edit.suggest words ~elsewhere:false ~subject ~expected units);
      (fun () -> Formula_mistake.power words ~subject ~expected units);
      (fun () -> Distant_number.chosen words ~subject ~expected units);
      (fun () -> Wrong_unit_mistake.superfluous_function words ~subject ~expected units);
      (fun () -> Wrong_unit_mistake.gain words ~subject ~expected units);
      (fun () -> Wrong_unit_mistake.constant words ~subject ~expected units);
      (fun () -> Wrong_unit_mistake.parameter words ~subject ~expected units);
      (fun () -> Lacking_unit_mistake.of_a_literal words ~likely:true ~subject ~expected units);
      (fun () -> Lacking_unit_mistake.of_the_only_decimal words ~subject ~expected units);
      (fun () -> Wrong_unit_mistake.bare_parameter words ~subject ~expected units);
    ]

let units words ~subject ~at ~(expected : Expected.t) ~found (wanted, given) =
  let text = Wording.measure words and is_one u = Units.equal u Units.one in
  let error format = error ~code:"E0320" ~at format in
  let diagnostic =
    match expected.because with
    | Operand { operator; _ } ->
        error "the operands of `%s` have different units: `%s` and `%s`" operator (text wanted)
          (text given)
    | _ when is_one wanted -> error "expected no unit, found `%s`" (text given)
    | _ when is_one given -> error "expected the unit `%s`, found none" (text wanted)
    | _ -> error "expected the unit `%s`, found `%s`" (text wanted) (text given)
  in
  let is_number t = match Type.expand t with Number _ -> true | _ -> false in
  let diagnostic =
    here "this is %s" (Wording.described words found) diagnostic
    |> unit_of_literal words ~subject ~expected ~found (wanted, given)
  in
  let is_of_numbers = is_number expected.ty && is_number found in
  let certain =
    certain words ~subject ~expected ~is_first:(diagnostic.hints = []) (wanted, given)
  in
  let advice = likely words ~subject ~expected (wanted, given) in
  if is_of_numbers && certain <> None then
    (Option.get certain) { diagnostic with hints = []; fixes = [] }
  else if is_of_numbers && diagnostic.hints = [] && advice <> None then
    (Option.get advice) diagnostic
    |> signature_of_this words ~subject ~expected ~found (wanted, given)
  else if is_number expected.ty && is_number found then
    let first = against_signature words ~subject ~expected ~found (wanted, given) diagnostic in
    let is_signature = first <> None in
    let diagnostic = Option.value first ~default:diagnostic in
    Unit_conversion.suggest words ~subject ~expected (wanted, given)
      (if is_signature then { diagnostic with hints = [] } else diagnostic)
    |> (fun d ->
    match expected.because with
    | _ when not is_signature -> d
    | _
      when Unit_conversion.is_of_a_signal words expected
           && String.equal (Wording.measure words (Units.divide wanted given)) "s" ->
        { d with hints = d.hints @ diagnostic.hints }
    | _ -> { d with hints = diagnostic.hints @ d.hints })
    |> by_time words ~expected
    |> (fun d ->
    match
      Lacking_unit_mistake.of_a_literal words ~likely:false ~subject ~expected (wanted, given)
    with
    | Some complete when d.hints = [] -> complete d
    | _ -> d)
    |> factor_without_unit words ~subject (wanted, given)
    |> (if is_signature then Fun.id
        else signature_of_this words ~subject ~expected ~found (wanted, given))
    |> turn words ~subject ~expected (wanted, given)
    |> plain_number words ~subject ~expected (wanted, given)
  else
    (match
       first_of
         [
           (fun () -> Lacking_unit_mistake.of_fields words ~subject ~expected (wanted, given));
           (fun () -> Formula_mistake.of_fields words ~subject (wanted, given));
         ]
     with
    | Some complete -> complete diagnostic
    | None -> (
        match Lacking_unit_mistake.of_an_argument words ~subject (wanted, given) with
        | Some complete -> complete diagnostic
        | None -> without_brackets words (wanted, given) diagnostic))
    |> (fun d ->
    match expected.because with
    | (Signature _ | Output (Signature _))
      when d.hints = [] && not (Units.is_open wanted || Units.is_open given) ->
        hint_for_signature words ~expected ~found d
    | _ -> d)
    |> note "expected %s, found %s"
         (Wording.described words expected.ty)
         (Wording.described words found)
