open Basis
open Typing
open Diagnostic

let is_open (wanted, given) = Units.is_open wanted || Units.is_open given

(* {1 The changes} *)

type kind = Operation of string  (** the function that replaces the current one *) | Without_power

type edit = {
  part : Resolve.Ir.expr;  (** the part of the formula that changes *)
  at : Span.t;  (** the text to replace *)
  text : string;
  whole : string;  (** the text of the part after the change *)
  factor : Units.t;  (** the change multiplies the unit of the formula by this one *)
  kind : kind;
}

(* Maximum length of a chain of names to follow. *)
let deepest = 4

let second words =
  (Environment.unit_ (Wording.environment words) (Environment.built_in "s")).measure

let of_operation words ~power (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply
      {
        head = { desc = Global { name = ("integral" | "derivative") as name; _ }; span; _ };
        argument;
        style = Juxtaposed;
      } ->
      let other = if String.equal name "integral" then "derivative" else "integral" in
      let seconds = if String.equal name "integral" then -2 else 2 in
      Option.map
        (fun x ->
          {
            part = e;
            at = span;
            text = other;
            whole = Printf.sprintf "%s %s" other x;
            factor = Units.power (second words) (Rational.of_int (seconds * power));
            kind = Operation other;
          })
        (Formula.grouped words argument)
  | _ -> None

let of_power words ~power (e : Resolve.Ir.expr) =
  match e.desc with
  | Power { base; exponent } when exponent > 1 -> (
      match (Formula.unit_of words base, Formula.grouped words base) with
      | Some u, Some text when not (Units.equal u Units.one) ->
          Some
            {
              part = e;
              at = e.span;
              text;
              whole = text;
              factor = Units.power u (Rational.of_int ((1 - exponent) * power));
              kind = Without_power;
            }
      | _ -> None)
  | _ -> None

(* All possible changes to the factors of a product and to the definitions of the names among
   them. *)
let rec edits words ~depth ~power (e : Resolve.Ir.expr) =
  let of_factor ((e : Resolve.Ir.expr), exponent) =
    let power = power * exponent in
    match (of_operation words ~power e, of_power words ~power e, e.desc) with
    | Some edit, _, _ | None, Some edit, _ -> [ edit ]
    | None, None, (Local _ | Global _) when depth < deepest ->
        let value = Bare_number.value words e in
        if value == e then [] else edits words ~depth:(depth + 1) ~power value
    | None, None, _ -> []
  in
  List.concat_map of_factor (Formula.factors e)

let fitting words (e, (wanted, given)) =
  match Units.divide wanted given with
  | missing ->
      List.filter (fun edit -> Units.equal edit.factor missing) (edits words ~depth:0 ~power:1 e)
  | exception Rational.Out_of_range -> []

let the_only_edit words sides =
  match List.concat_map (fun side -> fitting words side) sides with
  | [ edit ] -> Some edit
  | _ -> None

let is_within ~(outer : Span.t) (inner : Span.t) =
  String.equal outer.file inner.file
  && Span.line outer.start = Span.line inner.start
  && Span.column outer.start <= Span.column inner.start
  && Span.column inner.stop <= Span.column outer.stop

(* {1 The hints} *)

let shown words (e : Resolve.Ir.expr) = Option.value (Formula.text words e) ~default:"it"

let suggest ~elsewhere words ~subject ~(expected : Expected.t) units =
  if is_open units then None
  else
    let sides = Lacking_unit_mistake.sides words ~subject ~expected units in
    let complete (edit : edit) (d : Diagnostic.t) =
      let d =
        if is_within ~outer:d.at edit.part.span then d
        else
          label ~at:edit.part.span
            (match edit.kind with
            | Operation "integral" -> "this is a rate of change"
            | Operation _ -> "this is a sum over time"
            | Without_power -> "the power is computed here")
            d
      in
      (match edit.kind with
      | Operation other ->
          hint "for the %s, write `%s`"
            (if String.equal other "integral" then "sum over time" else "rate of change")
            edit.whole d
      | Without_power ->
          let formula =
            match
              List.find_opt
                (fun ((e : Resolve.Ir.expr), _) -> is_within ~outer:e.span edit.at)
                sides
            with
            | Some (e, _) -> Formula.with_part words e ~part:edit.at edit.text
            | None -> None
          in
          hint "use `%s` in place of `%s` to get the expected unit%s" edit.text
            (shown words edit.part)
            (Option.fold formula ~none:"" ~some:(Printf.sprintf ": write `%s`"))
            d)
      |> write edit.at edit.text
    in
    match the_only_edit words sides with
    | Some edit ->
        let is_part (e, _) = e == edit.part in
        let is_certain = edit.kind <> Without_power && not (List.exists is_part sides) in
        if is_certain = elsewhere then Some (complete edit) else None
    | None -> None

(* The largest product or quotient that contains the mistake. *)
let product_around words =
  let rec largest found = function
    | ({ expr; wanted } : Surroundings.enclosing) :: rest -> (
        match Formula.binary expr with
        | Some (("*" | "/"), _, _) -> largest (Some (expr, wanted)) rest
        | _ -> found)
    | [] -> found
  in
  match Wording.enclosing words with [] -> None | _ :: around -> largest None around

let is_angle words (e : Resolve.Ir.expr) =
  let ty =
    match e.desc with
    | Local x -> Wording.local words x
    | Global g -> Wording.declared_type words g
    | _ -> None
  in
  match Option.map Type.repr ty with
  | Some (Alias { alias = { name = "Angle"; _ }; _ }) -> true
  | _ -> false

let exchanged_angle words ~(subject : Resolve.Ir.expr option) ~(expected : Expected.t)
    (wanted, given) =
  match (expected.because, subject, product_around words) with
  | ( Parameter { callee = Some ("sin" | "cos" | "tan"); given = [ _ ]; _ },
      Some argument,
      Some (product, unit_) )
    when not (is_open (wanted, given)) -> (
      let is_the_angle ((e : Resolve.Ir.expr), power) = power = 1 && is_angle words e in
      let is_right_unit =
        match Option.map Type.expand unit_ with
        | Some (Number (_, u)) when not (Units.is_open u) ->
            let unit_of_factor ((e : Resolve.Ir.expr), power) =
              if is_within ~outer:e.span argument.span then Some Units.one
              else
                Option.map
                  (fun u -> Units.power u (Rational.of_int power))
                  (Formula.unit_of words e)
            in
            let multiplied product u = Option.map (Units.multiply product) u in
            Option.fold ~none:false ~some:(Units.equal u)
              (List.fold_left
                 (fun product factor ->
                   Option.bind product (fun product -> multiplied product (unit_of_factor factor)))
                 (Some given) (Formula.factors product))
        | _ -> true
      in
      match List.filter is_the_angle (Formula.factors product) with
      | [ (angle, _) ] when is_right_unit -> (
          match (Formula.grouped words angle, Formula.as_factor words argument) with
          | Some a, Some x ->
              let replacements = [ (angle.span, x); (argument.span, a) ] in
              Option.map
                (fun text d ->
                  hint "`%s` is an angle, and `%s` is in `%s`: write `%s`" a (shown words argument)
                    (Wording.measure words given) text d
                  |> fix (Printf.sprintf "write `%s`" text) replacements)
                (Formula.with_parts words product replacements)
          | _ -> None)
      | _ -> None)
  | _ -> None

(* {1 Records} *)

(* A change that gives another field the unit of this one. *)
let of_a_field words ~(subject : Resolve.Ir.expr option) ~(expected : Expected.t) (wanted, given) =
  let record =
    List.find_map
      (fun ({ expr; _ } : Surroundings.enclosing) ->
        match expr.desc with Record { fields; _ } -> Some fields | _ -> None)
      (Wording.enclosing words)
  in
  match (expected.because, record, subject) with
  | Field { name; _ }, Some fields, Some e when not (is_open (wanted, given)) ->
      let of_other ((other : Syntax.Ir.name), (value : Resolve.Ir.expr)) =
        if String.equal other.text name then None
        else
          match fitting words (value, (given, wanted)) with
          | [ ({ kind = Without_power; _ } as edit) ] when is_within ~outer:value.span edit.at ->
              Option.map
                (fun text -> (other.text, value, text))
                (Formula.with_part words value ~part:edit.at edit.text)
          | _ -> None
      in
      Option.map
        (fun (other, (value : Resolve.Ir.expr), text) d ->
          label ~at:value.span "the field `%s` is in `%s`" other (Wording.measure words wanted) d
          |> hint "the two fields must have the same unit: if `%s` is right, write `%s = %s`"
               (shown words e) other text
          |> write value.span text)
        (List.find_map of_other fields)
  | _ -> None

let of_a_record words ~(subject : Resolve.Ir.expr option) (wanted, given) =
  let fields =
    match Option.map (Bare_number.value words) subject with
    | Some { desc = Record { fields; _ }; _ } -> fields
    | Some _ | None -> []
  in
  let has u (_, e) = Option.fold (Formula.unit_of words e) ~none:false ~some:(Units.equal u) in
  match List.partition (has wanted) fields with
  | _ :: _, [ (((name : Syntax.Ir.name), value) as field) ]
    when (not (is_open (wanted, given))) && has given field ->
      let d_label d =
        label ~at:value.span "the field `%s` is in `%s`, unlike the others" name.text
          (Wording.measure words given) d
      in
      Some
        (match fitting words (value, (wanted, given)) with
        | [ edit ] when is_within ~outer:value.span edit.at ->
            let text = Formula.with_part words value ~part:edit.at edit.text in
            fun d ->
              hint "write `%s`"
                (match text with
                | Some text -> Printf.sprintf "%s = %s" name.text text
                | None -> edit.whole)
                (d_label d)
              |> write edit.at edit.text
        | _ ->
            fun d ->
              hint "give the field `%s` the unit `%s`, like the others" name.text
                (Wording.measure words wanted) (d_label d))
  | _ -> None
