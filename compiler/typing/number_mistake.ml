open Basis
open Diagnostic

(* {1 Units} *)

(* Written as an angle and nothing else: which is a number without a unit. *)
let angle : Resolve.Ir.unit_ option -> string option = function
  | Some { factors = [ (Declared { name = ("deg" | "rad") as name; _ }, _) ]; _ } -> Some name
  | Some _ | None -> None

let is_per_second words u = String.equal (Show.measure words u) "1/s"

(* A plain number written where one with a unit is needed. *)
let unit_of_literal words ~subject ~(expected : Expected.t) (wanted, given) diagnostic =
  let write (e : Resolve.Ir.expr option) unit_ =
    match e with
    | Some { desc = Number { digits; unit_ = None; _ }; _ }
      when Units.flexible_powers unit_ = [] && Units.rigid_powers unit_ = [] ->
        Some (Printf.sprintf "write `%s[%s]` if that is its unit" digits (Show.measure words unit_))
    | Some { desc = Number { digits; unit_ = written; _ }; _ } when is_per_second words unit_ ->
        let per_second angle =
          Printf.sprintf "write `%s[%s/s]` if that is how far it turns in a second" digits angle
        in
        Option.map per_second (angle written)
    | _ -> None
  in
  let other = match expected.because with Operand { other; _ } -> Some other | _ -> None in
  let is_one u = Units.equal u Units.one in
  let text =
    if is_one given then write subject wanted else if is_one wanted then write other given else None
  in
  Option.fold ~none:diagnostic ~some:(fun text -> hint text diagnostic) text

let units words ~subject ~at ~(expected : Expected.t) ~found (wanted, given) =
  let text = Show.measure words and is_one u = Units.equal u Units.one in
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
    here (Printf.sprintf "this is %s" (Show.described words found)) diagnostic
    |> unit_of_literal words ~subject ~expected (wanted, given)
  in
  if is_number expected.ty && is_number found then diagnostic
  else
    note
      (Printf.sprintf "expected %s, found %s" (Show.described words expected.ty) (Show.described words found))
      diagnostic

(* {1 Int and Float} *)

(* Between Int and Float the unit is no matter, unless it is known. *)
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
  Expected.make because (without_open_unit expected.ty)

let to_float (e : Resolve.Ir.expr option) =
  match Option.bind e Plain_name.of_expr with
  | Some name -> Printf.sprintf "write `toFloat %s`" name
  | None -> "`toFloat` makes a `Float` of an `Int`"

let to_int (e : Resolve.Ir.expr option) =
  let whole digits =
    match String.index_opt digits '.' with
    | Some point
      when String.for_all (fun c -> c = '0')
             (String.sub digits (point + 1) (String.length digits - point - 1)) ->
        Some (String.sub digits 0 point)
    | Some _ | None -> None
  in
  match e with
  | Some { desc = Number { digits; unit_ = None; _ }; _ } when whole digits <> None ->
      Printf.sprintf "a whole number has no point: `%s`" (Option.get (whole digits))
  | _ -> "`round`, `floor`, `ceiling` and `truncate` make an `Int` of a `Float`"

let representations words ~subject ~at ~(expected : Expected.t) ~found (wanted, given) =
  let text = Show.representation words in
  let found = without_open_unit found in
  let plain () =
    error ~code:"E0312" ~at "expected %s, found %s" (Show.described words expected.ty)
      (Show.described words found)
  in
  match (expected.because, (wanted : Type.representation), (given : Type.representation)) with
  | Operand { operator; other; _ }, Float, Int | Operand { operator; other; _ }, Int, Float ->
      let number = if given = Int then subject else Some other in
      error ~code:"E0312" ~at "the operands of `%s` are %s and %s" operator
        (Show.described words expected.ty) (Show.described words found)
      |> here (Printf.sprintf "this is %s" (Show.described words found))
      |> hint (to_float number)
  | Parameter { callee = Some "/"; _ }, Float, Int ->
      plain () |> hint "`div` divides whole numbers" |> hint (to_float subject)
  | _, Float, Int -> plain () |> hint (to_float subject)
  | _, Int, Float -> plain () |> hint (to_int subject)
  | _ ->
      plain ()
      |> note (Printf.sprintf "`%s` and `%s` are different representations" (text wanted) (text given))
