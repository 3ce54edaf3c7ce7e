open Basis
open Shape_fact

let with_each fields = String.concat ", " (List.map (Printf.sprintf "%s = …") fields)

(* How to build the record that is the first of two arguments, if only the second one is given. *)
let before fact ~callee ~(next : Resolve.Ir.expr) whole =
  match Show.quote fact.words next.span with
  | Some next ->
      let next = Source.grouped next in
      Printf.sprintf "write the record before `%s`: `%s (%s) %s`" next callee whole next
  | None -> Printf.sprintf "write the record: `%s`" whole

let how_to_build fact constructor fields =
  let whole = Printf.sprintf "%s { %s }" constructor (with_each fields) in
  match fact.expected.because with
  | Parameter { callee = Some callee; position = 1; given = _ :: _ :: _ as given; _ }
    when List.compare_lengths given fields <= 0
         && List.for_all (fun e -> Bare_number.literal fact.words e <> None) given ->
      let value i field =
        let text =
          Option.bind (List.nth_opt given i) (fun (e : Resolve.Ir.expr) ->
              Show.quote fact.words e.span)
        in
        Printf.sprintf "%s = %s" field (Option.value text ~default:"…")
      in
      Some
        (Printf.sprintf "`%s` takes one record in place of these numbers: write `%s (%s { %s })`"
           callee callee constructor
           (String.concat ", " (List.mapi value fields)))
  | Parameter { callee = Some callee; position = 1; takes = 2; given = [ next ]; _ } ->
      Some (before fact ~callee ~next whole)
  | Parameter _ -> Some (Printf.sprintf "write the record: `%s`" whole)
  | Signature _ | Output _ | Branch _ | Field _ ->
      Some
        (Printf.sprintf
           "write the whole record, `%s`, or a copy of a record `r` with another `%s`: `r { %s = … \
            }`"
           whole (List.hd fields) (List.hd fields))
  | _ -> None

let built fact =
  match (fact.wanted, fact.given, Show.fields fact.words fact.expected.ty) with
  | Data _, (Number _ | Bool), Some (constructor, fields)
    when List.compare_length_with fields 8 <= 0 ->
      Option.map (hinted fact) (how_to_build fact constructor fields)
  | _ -> None

(* `robotPose i.heading`, where a field of `robotPose i` was meant. *)
let bound_too_tightly words (subject : Resolve.Ir.expr option) fields =
  let of_application (e : Resolve.Ir.expr) =
    match e.desc with
    | Apply { head; argument = { desc = Field { record; field; _ }; _ }; style = Juxtaposed }
      when List.mem field.text fields -> (
        match (Show.quote words head.span, Show.quote words record.span) with
        | Some f, Some x ->
            Some
              (Printf.sprintf "a field binds tighter than application: write `(%s %s).%s`" f x
                 field.text)
        | _ -> None)
    | _ -> None
  in
  match subject with
  | Some { desc = Local x; _ } -> Option.bind (Show.definition words x) of_application
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
        (fun (_, fields) -> hinted fact (parts fact fields))
        (Show.fields fact.words fact.found)
  | _ -> None

let compared_with_a_number fact =
  match (fact.wanted, fact.given, other_operand fact) with
  | Data _, Number _, Some _ ->
      Option.map
        (fun (_, fields) ->
          hinted fact
            (Printf.sprintf
               "the other operand is a record with the fields %s: choose one, as in `r.%s`"
               (String.concat ", " (List.map (Printf.sprintf "`%s`") fields))
               (List.hd fields)))
        (Show.fields fact.words fact.expected.ty)
  | _ -> None

let in_place_of_a_part fact =
  match (fact.wanted, fact.given, source fact) with
  | Data _, Data _, Some text ->
      Option.map
        (fun field ->
          let cure = Printf.sprintf "%s.%s" (Source.grouped text) field in
          let d = hinted fact (Printf.sprintf "use its field: `%s`" cure) in
          match fact.subject with
          | Some e ->
              Diagnostic.fix (Printf.sprintf "write `%s`" cure) [ (e.span, "(" ^ cure ^ ")") ] d
          | None -> d)
        (Show.field_of fact.words fact.found ~of_:fact.expected.ty)
  | _ -> None
