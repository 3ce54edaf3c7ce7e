open Basis
open Typing
open Diagnostic

(* In a mismatch between Int and Float, an undetermined unit is irrelevant, so it is not shown. *)
let without_open_unit t =
  match Type.expand t with
  | Number (r, u)
    when Units.flexible_powers u <> [] && Units.base_powers u = [] && Units.rigid_powers u = [] ->
      Type.Number (r, Units.one)
  | _ -> t

let without_open_units (expected : Expected.t) =
  let because : Expected.reason =
    match expected.because with
    | Operand o -> Operand { o with other_type = without_open_unit o.other_type }
    | because -> because
  in
  { expected with ty = without_open_unit expected.ty; because }

(* The prefix that applies a conversion to each number in a value of this type. *)
let for_each t =
  match Type.expand t with
  | Data { tycon; _ } when tycon = Environment.array -> Some "map "
  | _ when Environment.is_event t -> Some "mapE "
  | Number _ -> Some ""
  | _ -> None

let to_float words ~found (e : Resolve.Ir.expr option) =
  let text = Option.bind e (fun (e : Resolve.Ir.expr) -> Wording.quote words e.span) in
  match (text, for_each found) with
  | Some text, Some each ->
      fun d ->
        let text = Printf.sprintf "%stoFloat %s" each (Source.grouped text) in
        hint "write `%s`" text d
        |> fix (Printf.sprintf "write `%s`" text) [ ((Option.get e).span, "(" ^ text ^ ")") ]
  | None, Some (("map " | "mapE ") as each) ->
      hint "use `%stoFloat` to convert each `Int` to a `Float`" each
  | _ -> hint "use `toFloat` to convert an `Int` to a `Float`"

(* The likely unit of a number of this size: a speed of 200 is probably in mm/s. *)
let unit_of_count measure (number : Bare_number.t) =
  match (measure, float_of_string_opt number.digits) with
  | "m/s", Some x when x >= 10. -> "mm/s"
  | "m", Some x when x >= 20. -> "cm"
  | "s", Some x when x >= 20. -> "ms"
  | _ -> measure

(* An `Int` where a quantity with a unit is expected. If the expression is a name for a literal, the
   fix adds the unit to the literal. Otherwise the fix multiplies the `Int` by a unit. *)
let to_quantity words ~(expected : Expected.t) ~found (e : Resolve.Ir.expr option) =
  let wanted =
    match (expected.because, Type.expand expected.ty, Type.expand found) with
    | Operand { operator = "*" | "/"; _ }, _, _ -> None
    | _, Number (_, u), Number (_, v)
      when Units.equal v Units.one && (not (Units.is_open u)) && not (Units.equal u Units.one) ->
        Some u
    | _ -> None
  in
  match (wanted, e) with
  | Some u, Some e -> (
      let measure = Wording.measure words u in
      match (Bare_number.literal words e, Wording.quote words e.span) with
      | (Some { name = Some name; signature = Some place; at; negative = false; _ } as number), _
        when Wording.quote words place <> None && Span.line place.start <> Span.line at.start ->
          let number = Option.get number in
          let unit_ = unit_of_count measure number in
          let text = Printf.sprintf "%s[%s]" number.digits unit_ in
          Some
            (fun d ->
              label ~at "`%s` is defined as this number, which has no unit" name d
              |> hint "give `%s` its unit: `%s :: Float[%s]` and `%s = %s`" name name measure name
                   text
              |> fix
                   (Printf.sprintf "write `%s`" text)
                   [ (place, Printf.sprintf "Float[%s]" measure); (at, text) ])
      | _, Some text ->
          let fixed = Printf.sprintf "toFloat %s * 1[%s]" (Source.grouped text) measure in
          Some
            (fun d ->
              hint "if the number is in `%s`, write `%s`" measure fixed d
              |> fix (Printf.sprintf "write `%s`" fixed) [ (e.span, "(" ^ fixed ^ ")") ])
      | _, None -> None)
  | _ -> None

let to_int words ~found (e : Resolve.Ir.expr option) =
  let whole digits =
    match String.index_opt digits '.' with
    | Some point
      when String.for_all
             (fun c -> c = '0')
             (String.sub digits (point + 1) (String.length digits - point - 1)) ->
        Some (String.sub digits 0 point)
    | Some _ | None -> None
  in
  match e with
  | Some { desc = Number { digits; unit_ = None; _ }; span } when whole digits <> None ->
      fun d ->
        let text = Option.get (whole digits) in
        hint "write a whole number without a decimal point: `%s`" text d |> write span text
  | _ -> (
      match for_each found with
      | Some (("map " | "mapE ") as each) ->
          hint
            "use `%sround` to convert each `Float` to an `Int`, or use `floor`, `ceiling` or \
             `truncate` instead of `round`"
            each
      | _ -> (
          match Option.bind e (fun (e : Resolve.Ir.expr) -> Wording.quote words e.span) with
          | Some text ->
              let text = "round " ^ Source.grouped text in
              fun d ->
                hint "write `%s`, or use `floor`, `ceiling` or `truncate` instead of `round`" text d
                |> fix
                     (Printf.sprintf "write `%s`" text)
                     [ ((Option.get e).span, "(" ^ text ^ ")") ]
          | None ->
              hint "use `round`, `floor`, `ceiling` or `truncate` to convert a `Float` to an `Int`")
      )

(* `toFloat x`, where `x` is already a Float *)
let superfluous words ~(expected : Expected.t) (e : Resolve.Ir.expr option) =
  match (expected.because, e) with
  | Parameter { callee = Some "toFloat"; at; _ }, Some e ->
      Option.map
        (fun text d ->
          hint "remove `toFloat`: `%s` is already a `Float`" text d
          |> fix (Printf.sprintf "write `%s`" text) [ (Span.merge at e.span, Source.grouped text) ])
        (Wording.quote words e.span)
  | _ -> None

let representations words ~subject ~at ~(expected : Expected.t) ~found (wanted, given) =
  let text = Wording.representation words in
  let found = without_open_unit found in
  let plain () =
    error ~code:"E0312" ~at "expected %s, found %s"
      (Wording.described words expected.ty)
      (Wording.described words found)
  in
  let of_function =
    match ((wanted : Type.representation), (given : Type.representation)) with
    | Float, Int -> (
        match Function_unit_mistake.power words ~expected () with
        | Some complete -> Some complete
        | None -> Function_unit_mistake.quotient words ~expected)
    | Int, Float -> (
        match superfluous words ~expected subject with
        | Some complete -> Some complete
        | None -> Function_unit_mistake.whole_numbers words ~expected ~found)
    | _ -> None
  in
  let of_quantity =
    match ((wanted : Type.representation), (given : Type.representation)) with
    | Float, Int -> to_quantity words ~expected ~found subject
    | _ -> None
  in
  match (expected.because, (wanted : Type.representation), (given : Type.representation)) with
  | _ when of_function <> None -> (Option.get of_function) (plain ())
  | _ when of_quantity <> None -> (Option.get of_quantity) (plain ())
  | Operand { operator = "!"; _ }, _, Float -> plain () |> to_int words ~found subject
  | Operand { operator; other; _ }, Float, Int | Operand { operator; other; _ }, Int, Float ->
      let number = if given = Int then subject else Some other in
      error ~code:"E0312" ~at "the operands of `%s` are %s and %s" operator
        (Wording.described words expected.ty)
        (Wording.described words found)
      |> here "this is %s" (Wording.described words found)
      |> to_float words ~found number
  | Parameter { callee = Some "/"; _ }, Float, Int ->
      plain () |> hint "to divide whole numbers, use `div`" |> to_float words ~found subject
  | _, Float, Int -> plain () |> to_float words ~found subject
  | _, Int, Float -> plain () |> to_int words ~found subject
  | _ -> plain () |> note "`%s` and `%s` are different representations" (text wanted) (text given)

let makes name x =
  match name with
  | "Mark" -> Some (Printf.sprintf "to make a mark from a number, write `number \"name\" %s`" x)
  | "Seeds" -> Some (Printf.sprintf "write the first and the last seed: ``1 `to` %s``" x)
  | _ -> None
