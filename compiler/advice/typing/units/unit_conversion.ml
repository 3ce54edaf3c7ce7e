open Basis
open Typing
open Diagnostic

let is_per_second words u = String.equal (Wording.measure words u) "1/s"

(* The unitless number literals among the arguments, which determine the unit of the function's
   result. *)
let numbers_without_units words (e : Resolve.Ir.expr option) =
  let e = Option.map (Bare_number.value words) e in
  let plain e =
    match Bare_number.literal words e with
    | Some { digits; unit_ = None; name = None; negative = false; _ } -> Some digits
    | Some _ | None -> None
  in
  match Option.map Resolve.Walk.application e with
  | Some ({ desc = Global { name = "knob" | "min" | "max" | "clamp" | "limit" | "abs"; _ }; _ }, es)
    ->
      List.filter_map plain es
  | _ -> []

(* The source text of the application, with this unit added to its nonzero numbers. *)
let with_units words (e : Resolve.Ir.expr option) unit_ =
  let rec numbers (e : Resolve.Ir.expr) =
    match e.desc with
    | Apply { head; argument = { desc = Number { unit_ = None; digits; _ }; span }; _ }
      when float_of_string_opt digits <> Some 0. ->
        (span, digits) :: numbers head
    | Apply { head; _ } -> numbers head
    | _ -> []
  in
  let column (p : Span.position) = Span.column p in
  Option.bind
    (Option.map (Bare_number.value words) e)
    (fun (e : Resolve.Ir.expr) ->
      let start = column e.span.start in
      (* the last number first, so that the places before it keep their columns *)
      let add text ((at : Span.t), digits) =
        let from = column at.start - start and until = column at.stop - start in
        String.sub text 0 from
        ^ Printf.sprintf "%s[%s]" digits unit_
        ^ String.sub text until (String.length text - until)
      in
      Option.map (fun text -> List.fold_left add text (numbers e)) (Wording.quote words e.span))

let is_operand (expected : Expected.t) =
  match expected.because with Operand _ -> true | _ -> false

let is_of_a_filter (expected : Expected.t) =
  match expected.because with
  | Parameter { callee = Some ("lowPass" | "highPass"); position = 1; _ } -> true
  | _ -> false

let is_argument (expected : Expected.t) =
  match expected.because with Parameter _ -> true | _ -> false

(* The source text of the expression with this change. In a command, the change applies to the input
   if the signal function is `returnA`, and otherwise to a name for the output. *)
let changed words (subject : Resolve.Ir.expr option) change =
  let quote (e : Resolve.Ir.expr) = Wording.quote words e.span in
  match subject with
  | Some { desc = Apply { head = { desc = Global g; _ }; argument; style = Command }; _ }
    when String.equal g.name "returnA" ->
      "returnA -< " ^ change (Option.fold (quote argument) ~none:"e" ~some:Source.grouped)
  | Some ({ desc = Apply { style = Command; _ }; _ } as e) ->
      Printf.sprintf "y <- %s`, then `returnA -< %s"
        (Option.value (quote e) ~default:"sf -< x")
        (change "y")
  | subject -> change (Option.fold (Option.bind subject quote) ~none:"e" ~some:Source.grouped)

(* Suggests how to give two operands the same unit if one of them has none. *)
let operands words ~subject ~(expected : Expected.t) (wanted, given) d =
  match expected.because with
  | Operand { other; _ } ->
      let divided e u = changed words (Some e) (fun e -> Printf.sprintf "%s / 1[%s]" e u) in
      let multiplied e u = changed words (Some e) (fun e -> Printf.sprintf "%s * 1[%s]" e u) in
      let right = Option.value subject ~default:other in
      let quantity, plain, unit_ =
        if Units.equal wanted Units.one then (right, other, given) else (other, right, wanted)
      in
      let unit_ = Wording.measure words unit_ in
      hint "%s"
        (match Formula.binary plain with
        | Some ("!", _, _) ->
            Printf.sprintf
              "divide by the unit, `%s`; for values with different units, use a record instead of \
               an array"
              (divided quantity unit_)
        | _ ->
            Printf.sprintf "divide by the unit, `%s`, or multiply the plain number by it: `%s`"
              (divided quantity unit_) (multiplied plain unit_))
        d
  | _ -> d

(* Is the expression the signal of a `delay`? Then the initial value is probably the mistake. *)
let is_delayed (expected : Expected.t) =
  match expected.because with Parameter { callee = Some "delay"; _ } -> true | _ -> false

(* Adds the hint for an expression that is not a literal, if one of the units is 1. *)
let with_a_unit words ~subject ~expected (wanted, given) diagnostic =
  if
    Units.equal given Units.one
    && (not (is_operand expected || is_delayed expected))
    && subject <> None
  then
    let unit_ = Wording.measure words wanted in
    hint "if the number is in `%s`, multiply by the unit: `%s`" unit_
      (changed words subject (fun e -> Printf.sprintf "%s * 1[%s]" e unit_))
      diagnostic
  else operands words ~subject ~expected (wanted, given) diagnostic

let rec is_of_time (e : Resolve.Ir.expr option) =
  match e with
  | Some { desc = Global { name = "time"; _ }; _ } -> true
  | Some { desc = Apply { head; argument; _ }; _ } ->
      is_of_time (Some head) || is_of_time (Some argument)
  | Some _ | None -> false

(* `2[g]` as an acceleration. *)
let gravities words (subject : Resolve.Ir.expr option) wanted =
  match subject with
  | Some
      {
        desc =
          Number { digits; unit_ = Some { factors = [ (Declared { name = "g"; _ }, _) ]; _ }; _ };
        span;
      }
    when String.equal (Wording.measure words wanted) "m/s^2" ->
      Option.map
        (fun x -> (Printf.sprintf "%.5g[m/s^2]" (x *. 9.80665), span))
        (float_of_string_opt digits)
  | _ -> None

(* Suggests the square or the square root. *)
let power words ~(subject : Resolve.Ir.expr option) ~expected (wanted, given) diagnostic =
  let with_e format = changed words subject (Printf.sprintf format) in
  let write text d =
    Option.fold subject ~none:d ~some:(fun (e : Resolve.Ir.expr) ->
        fix (Printf.sprintf "write `%s`" text) [ (e.span, "(" ^ text ^ ")") ] d)
  in
  if Units.equal (Units.multiply given given) wanted && is_operand expected then
    let text = with_e "%s ^ 2" in
    Some (hint "write `%s`, which has the expected unit" text diagnostic |> write text)
  else if Units.equal (Units.multiply wanted wanted) given && not (is_per_second words wanted) then
    let text = with_e "sqrt %s" in
    let is_product = Option.fold subject ~none:false ~some:(Formula.is_product words) in
    Some
      (hint "%s"
         (if is_product then Printf.sprintf "for the square root, write `%s`" text
          else Printf.sprintf "write `%s`, which has the expected unit" text)
         diagnostic
      |> write text)
  else None

let is_of_a_signal words (expected : Expected.t) =
  match expected.because with
  | Output _ -> true
  | Signature _ -> Wording.inputs words <> []
  | _ -> false

(* `way < 2[m]`, where `way` is a velocity: an `integral` may be missing. *)
let of_the_other_operand words ~(expected : Expected.t) (wanted, given) =
  match expected.because with
  | Operand { operator; other; _ } when Wording.inputs words <> [] ->
      let factor = Wording.measure words (Units.divide given wanted) in
      let run what f =
        Option.map
          (fun text ->
            let text = f ^ " " ^ Source.grouped text in
            fun d ->
              hint "for the %s, write `%s` before the `%s`" what text operator d
              |> write other.span text)
          (Wording.quote words other.span)
      in
      if Bare_number.literal words other <> None then None
      else if String.equal factor "s" then run "sum over time" "integral"
      else if String.equal factor "1/s" then run "rate of change" "derivative"
      else None
  | _ -> None

(* In `min (d - 0.4[m]) 0.3[m/s]`, a missing gain is more likely than a wrong unit. *)
let gain_of_an_earlier_argument words ~(expected : Expected.t) (wanted, given) =
  match expected.because with
  | Parameter { given = arguments; position; decided_by; _ }
    when String.equal (Wording.measure words (Units.divide given wanted)) "1/s" -> (
      let decides i (e : Resolve.Ir.expr) =
        i < position - 1
        && Bare_number.literal words e = None
        && List.exists (fun (d : Expected.decider) -> Span.compare d.place e.span = 0) decided_by
      in
      match List.filteri decides arguments with
      | [ e ] ->
          Option.map
            (fun text ->
              hint "to convert `%s` to `%s`, multiply by a gain, as in `0.5[1/s] * %s`"
                (Wording.measure words wanted) (Wording.measure words given) (Source.grouped text))
            (Wording.quote words e.span)
      | _ -> None)
  | _ -> None

(* Suggests multiplying by a time or integrating over time. *)
let over_time words ~(subject : Resolve.Ir.expr option) ~(expected : Expected.t) diagnostic =
  let with_e format = changed words subject (Printf.sprintf format) in
  let times = with_e (if is_of_time subject then "time () * %s" else "1[s] * %s") in
  let integral = with_e "integral %s" in
  match subject with
  | Some e when is_of_a_signal words expected && not (is_of_time subject) ->
      (* this hint comes before the one about the signature *)
      let first =
        suggestion "for the sum over time, write `%s`; for a fixed time, `%s`" integral times
      in
      { diagnostic with hints = first :: diagnostic.hints }
      |> fix (Printf.sprintf "write `%s`" integral) [ (e.span, "(" ^ integral ^ ")") ]
  | _ ->
      hint "multiply by a time, as in `%s`, or, for the sum over time, write `%s`" times integral
        diagnostic

(* A rate where a time is expected, or the reverse. *)
let between_rate_and_time words ~subject ~expected ~wanted d =
  let with_e format = changed words subject (Printf.sprintf format) in
  let replace text =
    Option.fold subject ~none:Fun.id ~some:(fun (e : Resolve.Ir.expr) -> write e.span text)
  in
  if is_of_a_filter expected && not (String.equal (Wording.measure words wanted) "Hz") then
    let cutoff = with_e "(1 / (2 * pi * %s))" in
    hint "this argument must be a time constant: for the cutoff frequency `%s`, write `%s`"
      (with_e "%s") cutoff d
    |> replace cutoff
  else
    hint "to convert between a rate and a time, write `%s`"
      (with_e (if is_argument expected then "(1 / %s)" else "1 / %s"))
      d
    |> replace (with_e "(1 / %s)")

(* A function whose result has the same unit as its numeric arguments, such as `knob`. *)
let of_numbers words ~subject ~wanted d =
  let digits = List.hd (numbers_without_units words subject) in
  let unit_ = Wording.measure words wanted in
  hint "%s"
    (match with_units words subject unit_ with
    | Some text -> Printf.sprintf "give the numbers their unit: `%s`" text
    | None -> Printf.sprintf "give the numbers their unit, as in `%s[%s]`" digits unit_)
    d
  |>
  match subject with
  | Some { desc = Local x; span } ->
      let at =
        Option.fold (Wording.definition words x) ~none:span ~some:(fun (e : Resolve.Ir.expr) ->
            e.span)
      in
      Reason_label.defines ~at x.name
  | _ -> Fun.id

let suggest words ~subject ~(expected : Expected.t) (wanted, given) diagnostic =
  let factor = Wording.measure words (Units.divide wanted given) in
  let with_e format = changed words subject (Printf.sprintf format) in
  let written =
    match subject with
    | Some { desc = Number n; span } -> Some (n.digits, span)
    | Some _ | None -> None
  in
  let plain = written = None && numbers_without_units words subject <> [] in
  if Units.is_open wanted || Units.is_open given then diagnostic
  else if
    List.mem
      (Wording.measure words wanted, Wording.measure words given)
      [ ("s", "1/s"); ("s", "Hz"); ("Hz", "s") ]
  then between_rate_and_time words ~subject ~expected ~wanted diagnostic
  else if Units.equal given Units.one && plain then of_numbers words ~subject ~wanted diagnostic
  else if Units.equal given Units.one && String.equal factor "1/s" && diagnostic.hints = [] then
    hint "multiply the plain number by a unit or a gain in `1/s`, as in `%s`" (with_e "1[1/s] * %s")
      diagnostic
  else if Units.equal wanted Units.one && String.equal factor "s" && is_of_a_signal words expected
  then over_time words ~subject ~expected diagnostic
  else if
    Units.equal wanted Units.one && diagnostic.hints = [] && written = None
    && not (is_operand expected)
  then
    let unit_ = Wording.measure words given in
    hint "to get a plain number, divide by the unit: `%s`"
      (changed words subject (fun e -> Printf.sprintf "%s / 1[%s]" e unit_))
      diagnostic
  else if Units.equal given Units.one || Units.equal wanted Units.one then
    if diagnostic.hints = [] && written = None then
      with_a_unit words ~subject ~expected (wanted, given) diagnostic
    else diagnostic
  else if gravities words subject wanted <> None then
    let text, at = Option.get (gravities words subject wanted) in
    hint "`g` means gram: for a multiple of the gravitational acceleration, write `%s`" text
      diagnostic
    |> write at text
  else if written <> None then
    let digits, at = Option.get written in
    let text = Printf.sprintf "%s[%s]" digits (Wording.measure words wanted) in
    diagnostic
    |> Option.value (gain_of_an_earlier_argument words ~expected (wanted, given)) ~default:Fun.id
    |> hint "write `%s` if you meant that unit" text
    |> write at text
    |> Option.value (of_the_other_operand words ~expected (wanted, given)) ~default:Fun.id
  else
    match power words ~subject ~expected (wanted, given) diagnostic with
    | Some diagnostic -> diagnostic
    | None when String.equal factor "1/s" || String.equal factor "Hz" ->
        hint "multiply by a gain, as in `%s`, or, for the rate of change, write `%s`"
          (with_e "0.5[1/s] * %s") (with_e "derivative %s") diagnostic
    | None when String.equal factor "s" -> over_time words ~subject ~expected diagnostic
    | None -> (
        match Lacking_unit_mistake.of_operands words ~subject ~expected (wanted, given) with
        | Some complete when diagnostic.hints = [] -> complete diagnostic
        | Some _ | None -> diagnostic)
