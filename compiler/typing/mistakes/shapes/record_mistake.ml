open Basis

let with_each fields = String.concat ", " (List.map (Printf.sprintf "%s = …") fields)

let built words (expected : Expected.t) =
  match Show.fields words expected.ty with
  | Some (constructor, fields) when List.compare_length_with fields 8 <= 0 -> (
      let whole = Printf.sprintf "%s { %s }" constructor (with_each fields) in
      match expected.because with
      | Parameter { callee = Some f; position = 1; takes = 2; given = [ next ]; _ } -> (
          match Show.quote words next.span with
          | Some next ->
              let next = Source.grouped next in
              Some
                (Printf.sprintf "it is a record, and stands before `%s`: `%s (%s) %s`" next f whole
                   next)
          | None -> Some (Printf.sprintf "it is a record: `%s`" whole))
      | Parameter _ -> Some (Printf.sprintf "it is a record: `%s`" whole)
      | Signature _ | Output _ | Branch _ | Field _ ->
          Some
            (Printf.sprintf
               "such a record is given as a whole: `%s`, or `r { %s = … }`, which is r with \
                another `%s`"
               whole (List.hd fields) (List.hd fields))
      | _ -> None)
  | _ -> None

(* `robotPose i.heading`, which is of another thing than `robotPose i`. *)
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

let parts words ~subject ~record:r found =
  let fields = match Show.fields words found with Some (_, fields) -> fields | None -> [] in
  let shown = List.filteri (fun i _ -> i < 4) fields in
  let all = String.concat ", " (List.map (fun f -> Printf.sprintf "`%s.%s`" r f) shown) in
  match (bound_too_tightly words subject fields, Type.expand found) with
  | Some hint, _ -> hint
  | None, Data { tycon = { name = "Vec2" | "Vec3"; _ }; _ } ->
      Printf.sprintf "a vector has parts, %s, and a length: `norm %s`" all r
  | None, _ -> "it is a record, of which the parts are " ^ all

let elements words ~wanted found =
  let element t =
    match Type.expand t with
    | Data { tycon; arguments = [ _; element ]; _ } when tycon = Environment.array -> Some element
    | _ -> None
  in
  match (Option.map Type.expand (element wanted), element found) with
  | Some (Number _ | Bool), Some record ->
      Option.map
        (fun (_, fields) ->
          let shown = List.filteri (fun i _ -> i < 4) fields in
          Printf.sprintf
            "its elements are records, of which the parts are %s: `map (\\x -> x.%s)` takes one of \
             each"
            (Enumeration.all (List.map (Printf.sprintf "`%s`") shown))
            (List.hd (List.rev shown)))
        (Show.fields words record)
  | _ -> None
