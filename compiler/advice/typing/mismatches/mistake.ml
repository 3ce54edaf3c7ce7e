open Basis
open Typing
open Diagnostic

let exponent_too_large ~at =
  Diagnostic.error ~code:"E0323" ~at "the exponent of a unit is too large"

let of_two_modules words diagnostic =
  match Wording.namesakes words with
  | [] -> diagnostic
  | name :: _ ->
      hint "two types have the name `%s`: use the same one in both places, or convert the value"
        name diagnostic

(* A local function without a signature has only one type. *)
let of_one_type words (expected : Expected.t) found (clash : Unify.clash) diagnostic =
  let shown t = Wording.described words t in
  let quantity t = match Type.expand t with Type.Number _ -> true | _ -> false in
  let is_of_a_number =
    match clash with
    | Different_units (u, v) -> Distant_number.compared words ~expected (u, v) <> None
    | _ -> false
  in
  match expected.because with
  | _ when is_of_a_number -> diagnostic
  | Parameter { callee = Some name; of_local = Some first; _ }
    when not (String.equal (shown expected.ty) (shown found)) ->
      let variable = if quantity expected.ty && quantity found then "Float[u]" else "a" in
      label ~at:first "because of this use of `%s`" name { diagnostic with hints = []; fixes = [] }
      |> hint
           "a local function without a signature has only one type: give `%s` a signature with a \
            variable, as in `%s :: %s -> …`"
           name name variable
  | _ -> diagnostic

(* If nothing more specific is known, refers to the argument by its number. *)
let by_signature words (expected : Expected.t) (d : Diagnostic.t) =
  match expected.because with
  | Parameter { head = Some { span; _ }; given; takes; _ }
    when List.length given > takes
         && Environment.is_task expected.ty
         && Span.line (List.nth given takes).span.start > Span.line span.stop ->
      hint "put `do` before a sequence of tasks" { d with hints = []; fixes = [] }
  | Parameter { head = Some { desc = Global { name = "atan"; _ }; _ }; given = [ y; x ]; _ } ->
      let text (e : Resolve.Ir.expr) default =
        let is_field = match e.desc with Field _ -> true | _ -> false in
        Option.fold (Wording.quote words e.span) ~none:default
          ~some:(if is_field then Fun.id else Source.grouped)
      in
      hint "`atan` takes one argument: to compute an angle from two sides, write `atan2 %s %s`"
        (text y "y") (text x "x") { d with hints = []; fixes = [] }
  | Parameter { head = Some { desc = Global g; _ }; given; takes; _ }
    when (d.hints = [] || (List.length given > takes && String.equal d.code "E0320"))
         && (takes > 1 || List.length given > takes)
         && (String.equal d.code "E0301"
            || List.length given > takes
            || (List.length given = 1 && takes = 2))
         && match g.name.[0] with 'a' .. 'z' -> true | _ -> false -> (
      match Wording.declared words g with
      | Some ty ->
          hint "%s"
            (if List.length given > takes || (List.length given = 1 && takes = 2) then
               Printf.sprintf "`%s` takes %s, but is applied to %d: `%s :: %s`" g.name
                 (Unrun_mistake.count takes) (List.length given) g.name ty
             else Printf.sprintf "the signature is `%s :: %s`" g.name ty)
            (if List.length given > takes then { d with hints = []; fixes = [] } else d)
      | None -> d)
  | _ -> d

(* Do these types have the same outer constructor? If so, the mismatch is between their parts. *)
let alike a b =
  match (Type.expand a, Type.expand b) with
  | Data { tycon; _ }, Data { tycon = other; _ } -> tycon = other
  | Tuple ts, Tuple us -> List.compare_lengths ts us = 0
  | Number _, Number _ | Function _, Function _ | Signal_function _, Signal_function _ -> true
  | _ -> false

(* Drops the arguments that determined a variable, unless that variable causes the mismatch. *)
let without_idle_deciders (expected : Expected.t) found (clash : Unify.clash) : Expected.t =
  let is_variable (t : Type.t) = match t with Flexible _ -> true | _ -> false in
  let of_sizes = match clash with Different (Size _, Size _) -> true | _ -> false in
  let matters ({ decides; a_size; _ } : Expected.decider) =
    a_size = of_sizes && (is_variable expected.ty || is_variable decides || alike expected.ty found)
  in
  match expected.because with
  | Parameter p ->
      { expected with because = Parameter { p with decided_by = List.filter matters p.decided_by } }
  | _ -> expected

let mismatch words ({ subject; at; expected; found; clash } : Inference_fact.mismatch) =
  let expected = without_idle_deciders expected found clash in
  (* reserve the names in signatures, so that generated names do not clash with them *)
  if not (Wording.is_any_number expected.ty) then ignore (Wording.type_ words expected.ty);
  Wording.tell_apart words [ expected.ty; found ];
  let finish diagnostic =
    Reason_label.add_all words ~subject expected diagnostic
    |> of_one_type words expected found clash
    |> by_signature words expected |> of_two_modules words
  in
  match clash with
  | (Different _ | Different_units _)
    when Exchanged_parameters.diagnostic words ~subject ~at ~expected ~found <> None ->
      Option.get (Exchanged_parameters.diagnostic words ~subject ~at ~expected ~found)
  | Different_units _ when Setting_order.wrong words ~expected ~found <> None ->
      Option.get (Setting_order.wrong words ~expected ~found)
  | Different_units (wanted, given) -> (
      match Signature_mistake.promised_unit (wanted, given) with
      | Some (r, unit_) ->
          Signature_mistake.general_unit words ~at r unit_
          |> here "this is %s" (Wording.described words found)
      | None -> (
          match
            Shared_unit_mistake.of_an_earlier_number words ~expected ~found ~subject (wanted, given)
          with
          | Some diagnostic -> diagnostic
          | None ->
              finish (Number_mistake.units words ~subject ~at ~expected ~found (wanted, given))))
  | Different_representations (Rigid_representation r, other)
  | Different_representations (other, Rigid_representation r) ->
      Signature_mistake.general_representation words ~at r other
  | Different_representations (wanted, given) ->
      let expected = Representation_mistake.without_open_units expected in
      Representation_mistake.representations words ~subject ~at ~expected ~found (wanted, given)
      |> Reason_label.add_all words ~subject expected
  | Different (Rigid r, other) | Different (other, Rigid r) -> (
      match (Type.expand expected.ty, Type.expand found) with
      | (_, Signal_function _ | _, Function _) when Type.expand found == other ->
          finish (Shape_mistake.shapes words ~subject ~at ~expected ~found)
      | _ -> (
          match Output_mistake.of_sleeping words ~subject other with
          | Some d -> d
          | None -> Signature_mistake.general_type words ~at r other))
  | Different _ -> finish (Shape_mistake.shapes words ~subject ~at ~expected ~found)
  | Infinite _ ->
      finish
        (error ~code:"E0305" ~at "this would need an infinite type: expected %s, found %s"
           (Wording.described words expected.ty)
           (Wording.described words found))
  | Escaping ->
      finish
        (error ~code:"E0306" ~at
           "a variable of a signature cannot depend on a type outside the signature: expected %s, \
            found %s"
           (Wording.described words expected.ty)
           (Wording.described words found))
  | Out_of_range -> exponent_too_large ~at

let exchanged_pair words ~at (expected : Expected.t) ((a : Resolve.Ir.expr), first)
    ((b : Resolve.Ir.expr), second) =
  (* reserve the names in signatures *)
  ignore (Wording.type_ words expected.ty);
  let found = Type.Tuple [ first; second ] in
  let without_decider : Expected.reason -> Expected.reason = function
    | Parameter p -> Parameter { p with decided_by = [] }
    | because -> because
  in
  let expected = { expected with because = without_decider expected.because } in
  let d =
    error ~code:"E0301" ~at "the two parts of this pair are in the wrong order"
    |> Reason_label.add words expected
  in
  let of_signature =
    match expected.because with
    | Signature _ | Output (Signature _) -> ", or swap their types in the signature"
    | _ -> ""
  in
  match (Wording.quote words a.span, Wording.quote words b.span) with
  | Some a, Some b ->
      let text = Printf.sprintf "(%s, %s)" b a in
      hint "write `%s`%s" text of_signature d |> write at text
  | _ ->
      hint "expected %s, found %s"
        (Wording.described words expected.ty)
        (Wording.described words found) d

let too_large ~at (construct : Fact.construct) =
  let what =
    match construct with
    | Expression -> "this expression"
    | Field -> "a field"
    | Instance -> "this instance"
    | Declaration name -> Printf.sprintf "`%s`" name
    | Definition name -> Printf.sprintf "`%s` or of something in it" name
  in
  Diagnostic.error ~code:"E0316" ~at "the type of %s is too large" what
  |> Diagnostic.note "a type can have at most %d parts, nested at most %d levels deep"
       Final.most_parts Final.deepest

let too_many_updates ~at (record : Ir.constructor) ~updates ~most_fields =
  Diagnostic.error ~code:"E0413" ~at
    "the record updates up to here write more than %d fields, which is too many to compile"
    most_fields
  |> Diagnostic.note
       "an update writes all fields of its record; `%s` has %d fields and %d updates so far"
       record.constructor.name (List.length record.fields) updates
  |> Diagnostic.hint "change several fields in one update: `r { a = 1, b = 2 }`"
  |> Diagnostic.hint
       "put fields that change together into a smaller record, or keep them in an array"
