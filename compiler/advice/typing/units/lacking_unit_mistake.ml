open Basis
open Typing
open Diagnostic

let is_one u = Units.equal u Units.one

let is_operand (expected : Expected.t) =
  match expected.because with Operand _ -> true | _ -> false

let needed (wanted, given) power = Units.power (Units.divide wanted given) (Rational.of_int power)

let give words units d ((number : Bare_number.t), power) =
  Bare_number.give words number (Wording.measure words (needed units power)) d

(* The unit that the largest sum containing the mistake must have, if the context determines it. *)
let unit_of_the_sum words =
  let rec largest found = function
    | ({ expr; wanted } : Surroundings.enclosing) :: rest -> (
        match Formula.binary expr with
        | Some (("+" | "-"), _, _) -> largest wanted rest
        | _ -> found)
    | [] -> found
  in
  match Option.map Type.expand (largest None (Wording.enclosing words)) with
  | Some (Number (_, u)) when not (Units.is_open u) -> Some (Units.resolve u)
  | Some _ | None -> None

(* The operands in which adding a unit to a constant could correct the mismatch, each with its
   expected and its actual unit. *)
let sides words ~subject ~(expected : Expected.t) (wanted, given) =
  let this = Option.to_list (Option.map (fun e -> (e, (wanted, given))) subject) in
  match expected.because with
  | Operand { other; operator = "+" | "-"; _ } -> (
      let others = [ (other, (given, wanted)) ] in
      match unit_of_the_sum words with
      | Some u when Units.equal u wanted -> this
      | Some u when Units.equal u given -> others
      | Some _ | None -> this @ others)
  | Operand { other; operator = "<" | "<=" | ">" | ">=" | "==" | "/="; _ } ->
      this @ [ (other, (given, wanted)) ]
  | Operand _ -> []
  | _ -> this

let complete words ~subject ~(expected : Expected.t) (wanted, given) =
  let constants (e, units) =
    match Bare_number.factor words e with
    | [] -> None
    | constants -> Some (fun d -> List.fold_left (give words units) d constants)
  in
  if Units.is_open wanted || Units.is_open given then None
  else List.find_map constants (sides words ~subject ~expected (wanted, given))

let rec mentions names (e : Resolve.Ir.expr) =
  match e.desc with
  | Global { name; _ } -> List.mem name names
  | Apply { head; argument; _ } -> mentions names head || mentions names argument
  | Negate e -> mentions names e
  | _ -> false

(* Is the expression the product of a number and another value, rather than a formula of numbers
   alone? *)
let is_product_with_value words e =
  match Formula.factors (Bare_number.value words e) with
  | [ (a, _); (b, _) ] -> (
      match (Bare_number.literal words a, Bare_number.literal words b) with
      | Some { name = None; _ }, None | None, Some { name = None; _ } -> true
      | _ -> false)
  | _ -> false

(* Does the unit have only negative exponents? *)
let is_unit_of_a_gain u =
  let powers = Units.base_powers u in
  let is_negative (_, power) = Rational.is_negative power in
  powers <> [] && List.for_all is_negative powers

(* `0.5 * e` or `v / 0.3`: the unit that the literal should have. Excludes a divisor of 2 and
   formulas that contain `pi`, `time` or `sqrt`, because their numbers usually have no unit. *)
let of_a_literal ~likely words ~subject ~expected (wanted, given) =
  let all = sides words ~subject ~expected (wanted, given) in
  (* in a sum, the literal is a gain if the other operand has the right unit or contains a gain with
     a unit *)
  let is_gain e unit_ =
    is_unit_of_a_gain unit_
    &&
    let has_unit ((number : Bare_number.t), _) = number.unit_ <> None in
    match (expected.Expected.because, all) with
    | Operand { operator = "+" | "-"; _ }, [ _ ] -> true
    | Operand { operator = "+" | "-"; other; _ }, _ ->
        List.exists
          (fun other -> other != e && List.exists has_unit (Bare_number.written_factor words other))
          (other :: Option.to_list subject)
    | _ -> false
  in
  let fix_of (e, units) =
    match Bare_number.written_factor words e with
    | [ ((number : Bare_number.t), power) ]
      when Bare_number.literal words e = None
           && (number.unit_ <> None
              || String.contains number.digits '.' = likely
              || is_gain e (needed units power))
           && (not (mentions [ "pi"; "time"; "sqrt" ] (Bare_number.value words e)))
           && not (power < 0 && String.equal number.digits "2") -> (
        let unit_ = needed units power in
        match number.unit_ with
        | None
          when (not (is_one wanted || is_one given))
               || is_one given && is_product_with_value words e
                  && not (is_one wanted || is_operand expected) ->
            let text = Printf.sprintf "%s[%s]" number.digits (Wording.measure words unit_) in
            let what = if power > 0 then "factor" else "divisor" in
            let is_elsewhere =
              match subject with
              | Some ({ desc = Local _ | Global _; _ } : Resolve.Ir.expr) -> true
              | Some _ | None -> false
            in
            Some
              (fun d ->
                (if is_elsewhere then label ~at:number.at "this %s has no unit" what d else d)
                |> hint "if the %s `%s` has a unit, write it: `%s`" what number.digits text
                |> write number.at text)
        | None -> None
        | Some _ -> (
            match Wording.quote words number.at with
            | Some text when not (is_operand expected) ->
                let own =
                  Units.divide
                    (if power > 0 then given else wanted)
                    (if power > 0 then wanted else given)
                in
                (* without its unit, the number would fit *)
                if String.ends_with ~suffix:(Printf.sprintf "[%s]" (Wording.measure words own)) text
                then
                  Some
                    (fun d ->
                      hint "write `%s`, without a unit, if it is a plain number" number.digits d
                      |> write number.at number.digits)
                else None
            | Some _ | None -> None))
    | _ -> None
  in
  if Units.is_open wanted || Units.is_open given then None else List.find_map fix_of all

(* `n / perRev * 2 * pi * 0.04`: a formula without a unit, in which only one number has a decimal
   point. *)
let of_the_only_decimal words ~(subject : Resolve.Ir.expr option) ~expected (wanted, given) =
  let is_number e = Bare_number.literal words e <> None in
  let is_decimal (e, _) =
    match Bare_number.literal words e with
    | Some { digits; unit_ = None; _ } -> String.contains digits '.'
    | Some _ | None -> false
  in
  let factors =
    Option.fold subject ~none:[] ~some:(fun e -> Formula.factors (Bare_number.value words e))
  in
  match List.filter is_decimal factors with
  | [ (e, 1) ]
    when is_one given
         && (not (is_one wanted || is_operand expected || Units.is_open wanted))
         && List.length factors > 2
         && not (List.for_all (fun (e, _) -> is_number e) factors) ->
      Option.map
        (fun (number : Bare_number.t) d ->
          let unit_ = Wording.measure words wanted in
          let text = Printf.sprintf "%s[%s]" number.digits unit_ in
          label ~at:number.at "this number has no unit" d
          |> hint "if `%s` is in `%s`, write `%s`" number.digits unit_ text
          |> write number.at text)
        (Bare_number.literal words e)
  | _ -> None

(* The signal [x] of a difference [x - delay 0 x] or [x - previous x]. *)
let difference words (e : Resolve.Ir.expr) =
  match Formula.binary (Bare_number.value words e) with
  | Some ("-", x, before) -> (
      match (Bare_number.value words before).desc with
      | Apply { head; argument; style = Juxtaposed } -> (
          match head.desc with
          | Global { name = "previous"; _ }
          | Apply { head = { desc = Global { name = "delay"; _ }; _ }; _ }
            when Formula.text words argument <> None
                 && Formula.text words argument = Formula.text words x ->
              Formula.grouped words x
          | _ -> None)
      | _ -> None)
  | _ -> None

(* `x - delay 0 x` in place of a rate of change, possibly divided by a number that represents the
   length of the step. *)
let of_a_difference words ~(subject : Resolve.Ir.expr option) (wanted, given) =
  let signal e =
    let e = Bare_number.value words e in
    match (difference words e, Formula.binary e) with
    | Some x, _ -> Some x
    | None, Some (("/" | "*"), a, b) when Bare_number.literal words b <> None -> difference words a
    | None, Some ("*", a, b) when Bare_number.literal words a <> None -> difference words b
    | None, _ -> None
  in
  match subject with
  | Some e when List.mem (Wording.measure words (Units.divide wanted given)) [ "1/s"; "Hz" ] ->
      let with_fix x =
        let fixed = "derivative " ^ x in
        fun d ->
          hint
            "for the rate of change, write `%s`, which divides the difference by the length of the \
             step"
            fixed d
          |> fix
               (Printf.sprintf "write `%s`" fixed)
               [ ((Bare_number.value words e).span, "(" ^ fixed ^ ")") ]
      in
      Option.map with_fix (signal e)
  | Some _ | None -> None

(* `4 * off + 3[1/m] * derivative off`, where the gain of only one operand has a unit *)
let gain_without_unit words ~(subject : Resolve.Ir.expr option) ~(expected : Expected.t)
    (wanted, given) =
  let of_side (e, (wanted, given)) other =
    match (Bare_number.written_factor words e, Bare_number.written_factor words other) with
    | [ (({ unit_ = None; _ } as number : Bare_number.t), 1) ], factors
      when List.exists (fun ((n : Bare_number.t), _) -> n.unit_ <> None) factors ->
        let unit_ = Wording.measure words (Units.divide wanted given) in
        let text = Printf.sprintf "%s[%s]" number.digits unit_ in
        Some
          (fun d ->
            hint
              "if the gain `%s` should have a unit, like the gain in the other operand, write `%s`"
              number.digits text d
            |> write number.at text)
    | _ -> None
  in
  match (expected.because, subject) with
  | Operand { operator = "+" | "-"; other; _ }, Some e
    when not (Units.is_open wanted || Units.is_open given) -> (
      match of_side (e, (wanted, given)) other with
      | Some complete -> Some complete
      | None -> of_side (other, (given, wanted)) e)
  | _ -> None

(* `v + t`, where the product or the quotient of the operands has a simple unit. *)
let of_operands words ~(subject : Resolve.Ir.expr option) ~(expected : Expected.t) (wanted, given) =
  let simple u =
    match (Units.base_powers u, Units.is_open u, Units.rigid_powers u) with
    | [ (_, power) ], false, [] -> Rational.equal power Rational.one
    | _ -> false
  in
  let is_a_rate u = String.equal (Wording.measure words u) "m/s" in
  let has_a_number (e : Resolve.Ir.expr) = Bare_number.written_factor words e <> [] in
  match (expected.because, subject) with
  | Operand { operator = ("+" | "-") as operator; other; _ }, Some (e : Resolve.Ir.expr)
    when not (is_one wanted || is_one given) -> (
      let product = Units.multiply wanted given in
      let gain = Units.divide wanted given in
      match (Wording.quote words other.span, Wording.quote words e.span) with
      | Some a, Some b when is_a_rate product && not (has_a_number other || has_a_number e) ->
          let text = Printf.sprintf "%s * %s" (Source.grouped a) (Source.grouped b) in
          Some
            (fun d ->
              hint "the operands of `%s` must have the same unit: for a rate in `%s`, write `%s`"
                operator (Wording.measure words product) text d
              |> write (Span.merge other.span e.span) ("(" ^ text ^ ")"))
      | Some a, Some b when simple gain ->
          let factor = Printf.sprintf "1[%s]" (Wording.measure words gain) in
          Some
            (hint
               "the operands of `%s` must have the same unit: multiply `%s` by a quantity in `%s`, \
                as in `%s %s %s * %s`"
               operator b (Wording.measure words gain) a operator b factor)
      | Some a, Some b when simple product ->
          Some
            (hint
               "the operands of `%s` must have the same unit: if you meant the product, write `%s \
                * %s`, which is in `%s`"
               operator (Source.grouped a) (Source.grouped b) (Wording.measure words product))
      | _ -> None)
  | _ -> None

(* The number literals without a unit in a record, such as [Vec2 { x = 1, y = 2 }]. *)
let fields words (e : Resolve.Ir.expr) =
  match (Bare_number.value words e).desc with
  | Record { fields; _ } ->
      let bare ((name : Syntax.Ir.name), e) =
        match Bare_number.literal words e with
        | Some ({ unit_ = None; name = None; _ } as number) -> Some (name.text, number)
        | Some _ | None -> None
      in
      List.filter_map bare fields
  | _ -> []

let of_fields words ~(subject : Resolve.Ir.expr option) ~(expected : Expected.t) (wanted, given) =
  let record =
    match expected.because with
    | Operand { other; _ } when is_one wanted -> Some (other, given)
    | Parameter { given = arguments; position; _ } when is_one wanted && position > 1 ->
        Option.map (fun e -> (e, given)) (List.nth_opt arguments (position - 2))
    | _ when is_one given -> Option.map (fun e -> (e, wanted)) subject
    | _ -> None
  in
  match record with
  | Some (record, unit_) when not (Units.is_open unit_) -> (
      match fields words record with
      | [] -> None
      | numbers ->
          let unit_ = Wording.measure words unit_ in
          let literal (number : Bare_number.t) = Printf.sprintf "%s[%s]" number.digits unit_ in
          let shown (name, (number : Bare_number.t)) =
            Printf.sprintf "%s = %s%s" name (if number.negative then "-" else "") (literal number)
          in
          let edit (_, (number : Bare_number.t)) = (number.at, literal number) in
          let first = snd (List.hd numbers) in
          Some
            (fun d ->
              label ~at:first.at "this number has no unit" d
              |> hint "give the fields their unit: `%s`"
                   (String.concat ", " (List.map shown numbers))
              |> fix "give the fields their unit" (List.map edit numbers)))
  | Some _ | None -> None

(* The number literals without a unit in the arguments of an application. *)
let rec literals words (e : Resolve.Ir.expr) =
  match e.desc with
  | Number _ -> Option.to_list (Bare_number.literal words e)
  | Negate e | Lambda { body = e; _ } | Proc { body = { output = e; _ }; _ } -> literals words e
  | If { then_; else_; _ } -> literals words then_ @ literals words else_
  | Tuple es | Array es -> List.concat_map (literals words) es
  | Apply { head; argument; style = Juxtaposed } -> (
      match head.desc with
      | Apply _ -> literals words head @ literals words argument
      | _ -> literals words argument)
  | _ -> []

(* The named constants without a unit that scale one of the arguments of an application. *)
let rec scaled words (e : Resolve.Ir.expr) =
  match Bare_number.factor words e with
  | [] -> (
      match (Bare_number.value words e).desc with
      | Apply { head; argument; style = Juxtaposed } -> (
          match scaled words argument with
          | [] -> ( match head.desc with Apply _ -> scaled words head | _ -> [])
          | found -> found)
      | _ -> [])
  | found -> found

let of_an_argument words ~(subject : Resolve.Ir.expr option) (wanted, given) =
  let constants =
    if Units.is_open wanted || Units.is_open given then []
    else Option.fold subject ~none:[] ~some:(scaled words)
  in
  let is_bare (n : Bare_number.t) = n.unit_ = None && n.name = None in
  let is_decimal (n : Bare_number.t) = is_bare n && String.contains n.digits '.' in
  if constants <> [] then Some (fun d -> List.fold_left (give words (wanted, given)) d constants)
  else if (not (is_one given)) || Units.is_open wanted then None
  else
    let literals = Option.fold subject ~none:[] ~some:(literals words) in
    match (literals, List.filter is_decimal literals) with
    | [ number ], _ when is_bare number ->
        Some (Bare_number.give words number (Wording.measure words wanted))
    (* an integer is more likely to be a count *)
    | _, [ number ] -> Some (Bare_number.give words number (Wording.measure words wanted))
    | _, _ -> None

(* `v * r` in place of `v / r`, for an input or a parameter [r]. *)
let of_the_inverse words ~(subject : Resolve.Ir.expr option) (wanted, given) =
  match Option.bind subject Formula.binary with
  | Some ((("*" | "/") as operator), a, ({ desc = Local _ | Global _; _ } as divisor)) -> (
      let squared u = Units.multiply u u in
      let inverse u =
        if String.equal operator "*" then Units.divide given (squared u)
        else Units.multiply given (squared u)
      in
      match (Formula.unit_of words divisor, Formula.text words a, Formula.text words divisor) with
      | Some u, Some a, Some b when (not (is_one u)) && Units.equal (inverse u) wanted ->
          let text =
            Printf.sprintf "%s %s %s" a (if String.equal operator "*" then "/" else "*") b
          in
          Some
            (fun d ->
              hint "write `%s`, which has the expected unit" text d
              |> Option.fold subject ~none:Fun.id ~some:(fun (e : Resolve.Ir.expr) ->
                     write e.span text))
      | _ -> None)
  | _ -> None
