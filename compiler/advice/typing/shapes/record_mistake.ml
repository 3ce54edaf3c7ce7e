open Basis
open Shape_fact

let with_each fields = String.concat ", " (List.map (Printf.sprintf "%s = …") fields)

(* The hint for building the missing record, if it is the first of two arguments and only the second
   is given. *)
let before fact ~callee ~(next : Resolve.Ir.expr) whole =
  match Wording.quote fact.words next.span with
  | Some next ->
      let next = Source.grouped next in
      Diagnostic.suggestion ~topic:(Call callee) "write the record before `%s`: `%s (%s) %s`" next
        callee whole next
  | None -> Diagnostic.suggestion "write the record: `%s`" whole

let is_number words (e : Resolve.Ir.expr) =
  match e.desc with Number _ -> true | _ -> Bare_number.literal words e <> None

(* The corrected call for `pid 0.5 0.1 0 e`, which has numbers in place of the record. *)
let from_numbers fact ~callee constructor fields (given : Resolve.Ir.expr list) =
  let numbers, rest = List.partition (is_number fact.words) given in
  let quote (e : Resolve.Ir.expr) = Wording.quote fact.words e.span in
  let value i field =
    Printf.sprintf "%s = %s" field
      (Option.value (Option.bind (List.nth_opt numbers i) quote) ~default:"…")
  in
  let record =
    Printf.sprintf "(%s { %s })" constructor (String.concat ", " (List.mapi value fields))
  in
  match rest with
  | [] -> Some (callee ^ " " ^ record)
  | [ signal ] when List.nth given (List.length given - 1) == signal ->
      Option.map
        (fun text -> String.concat " " [ callee; record; Source.grouped text ])
        (quote signal)
  | _ -> None

let how_to_build fact constructor fields =
  let whole = Printf.sprintf "%s { %s }" constructor (with_each fields) in
  match fact.expected.because with
  | Parameter { callee = Some callee; position = 1; given = first :: _ :: _ as given; _ }
    when List.compare_length_with fields (List.length given - 1) >= 0
         && is_number fact.words first
         && from_numbers fact ~callee constructor fields given <> None ->
      Some
        (Diagnostic.suggestion ~topic:(Call callee)
           "`%s` takes a single record, not separate numbers: write `%s`" callee
           (Option.get (from_numbers fact ~callee constructor fields given)))
  | Parameter { callee = Some callee; position = 1; takes = 2; given = [ next ]; _ } ->
      Some (before fact ~callee ~next whole)
  | Parameter _ -> Some (Diagnostic.suggestion "write the record: `%s`" whole)
  | Signature _ | Output _ | Branch _ | Field _ ->
      Some
        (Diagnostic.suggestion
           "write the whole record, `%s`, or a copy of a record `r` with a different `%s`: `r { %s \
            = … }`"
           whole (List.hd fields) (List.hd fields))
  | _ -> None

let built fact =
  match (fact.wanted, fact.given, Wording.fields fact.words fact.expected.ty) with
  | Data _, (Number _ | Bool), Some (constructor, fields)
    when List.compare_length_with fields 8 <= 0 ->
      Option.map
        (fun hint -> Diagnostic.suggest hint (different fact))
        (how_to_build fact constructor fields)
  | _ -> None

(* `robotPose i.heading`, where a field of `robotPose i` was meant. *)
let bound_too_tightly words (subject : Resolve.Ir.expr option) fields =
  let of_application (e : Resolve.Ir.expr) =
    match e.desc with
    | Apply { head; argument = { desc = Field { record; field; _ }; _ }; style = Juxtaposed }
      when List.mem field.text fields -> (
        match (Wording.quote words head.span, Wording.quote words record.span) with
        | Some f, Some x ->
            Some
              (Printf.sprintf
                 "field access binds tighter than function application: write `(%s %s).%s`" f x
                 field.text)
        | _ -> None)
    | _ -> None
  in
  match subject with
  | Some { desc = Local x; _ } -> Option.bind (Wording.definition words x) of_application
  | Some e -> of_application e
  | None -> None

let parts fact fields =
  let r = grouped fact "r" in
  let shown = List.filteri (fun i _ -> i < 4) fields in
  let all = String.concat ", " (List.map (fun f -> Printf.sprintf "`%s.%s`" r f) shown) in
  match (bound_too_tightly fact.words fact.subject fields, fact.given) with
  | Some hint, _ -> hint
  | None, Data { tycon = { name = "Vec2"; _ }; _ } when String.equal (callee fact) "atan2" ->
      Printf.sprintf "for the direction of a vector, write `direction %s`, with `import Geometry`" r
  | None, Data { tycon = { name = "Vec2" | "Vec3"; _ }; _ } ->
      Printf.sprintf "for a component of the vector, write %s; for its length, write `norm %s`" all
        r
  | None, _ -> "this is a record: choose one of its fields, " ^ all

let in_place_of_a_number fact =
  match (fact.wanted, fact.given) with
  | Number _, Data _ ->
      Option.map
        (fun (_, fields) -> hinted fact "%s" (parts fact fields))
        (Wording.fields fact.words fact.found)
  | _ -> None

let compared_with_a_number fact =
  match (fact.wanted, fact.given, other_operand fact) with
  | Data _, Number _, Some _ ->
      Option.map
        (fun (_, fields) ->
          hinted fact "the other operand is a record with the fields %s: choose one, as in `r.%s`"
            (String.concat ", " (List.map (Printf.sprintf "`%s`") fields))
            (List.hd fields))
        (Wording.fields fact.words fact.expected.ty)
  | _ -> None

let in_place_of_a_part fact =
  match (fact.wanted, fact.given, source fact) with
  | Data _, Data _, Some text ->
      Option.map
        (fun field ->
          let fixed = Printf.sprintf "%s.%s" (Source.grouped text) field in
          let d = hinted fact "use its field: `%s`" fixed in
          match fact.subject with
          | Some e ->
              Diagnostic.fix (Printf.sprintf "write `%s`" fixed) [ (e.span, "(" ^ fixed ^ ")") ] d
          | None -> d)
        (Wording.field_of fact.words fact.found ~of_:fact.expected.ty)
  | _ -> None
