open Basis
open Context

let position = Environment.position

(* The field types of a record of type [ty]. *)
let field_types ctx (constructor : Environment.constructor) ~at ty =
  let instance, _ = use ctx ~at ~name:constructor.ir.constructor.name constructor.scheme in
  let fields, result = Environment.fields constructor instance in
  match Unify.types ty result with
  | Ok () -> fields
  | Error _ ->
      Diagnostic.bug ~stage:"Typing.Infer_record" "%s does not build its own type"
        constructor.ir.constructor.name

let field_type ctx constructor ~at ty index =
  match Environment.own_type constructor index with
  | Some own -> own
  | None -> List.nth (field_types ctx constructor ~at ty) index

let suggest (name : Syntax.Ir.name) known diagnostic =
  match Suggest.closest name.text known with
  | Some near ->
      Diagnostic.hint (Printf.sprintf "did you mean `%s`?" near) diagnostic
      |> Diagnostic.write name.span near
  | None -> diagnostic

(* The constructor that has this field, in a type with several constructors. *)
let one_of_several environment ty name =
  match Type.expand ty with
  | Data { tycon; _ } -> (
      match (Environment.type_ environment tycon).definition with
      | Data { constructors; _ } ->
          List.find_opt (fun (c : Ir.constructor) -> List.mem_assoc name c.fields) constructors
      | Alias _ | Builtin | Foreign -> None)
  | _ -> None

(* Is there a function or signal function of that name? *)
let of_that_name ctx (name : Syntax.Ir.name) =
  let found (g : Ir.Global.t) (entry : entry) earlier =
    if not (String.equal g.name name.text) then earlier
    else
      match Type.expand entry.scheme.body with
      | Function _ -> Some "function"
      | Signal_function _ -> Some "signal function"
      | _ -> earlier
  in
  Resolve.Global_table.fold found ctx.globals None

(* A function or signal function of that name, used with field syntax by mistake. *)
let as_a_function ctx (name : Syntax.Ir.name) ~(record : Resolve.Ir.expr) diagnostic =
  match of_that_name ctx name with
  | None ->
      Option.map
        (fun text -> Diagnostic.hint text diagnostic)
        (Resolve.Other_languages.robot name.text)
  | Some kind ->
      let argument words =
        Option.fold (Show.quote words record.span) ~none:"x" ~some:Source.grouped
      in
      Some
        (Diagnostic.hint
           (Printf.sprintf "`%s` is a %s: write `%s %s`" name.text kind name.text
              (argument (words ctx)))
           diagnostic
        |> Diagnostic.fix
             (Printf.sprintf "write `%s %s`" name.text (argument (words ctx)))
             [
               ( Span.merge record.span name.span,
                 Printf.sprintf "(%s %s)" name.text (argument (words ctx)) );
             ])

let rec takes_an_array (t : Type.t) =
  match Type.expand t with
  | Function (parameter, result) -> (
      match Type.expand parameter with
      | Data { tycon; _ } when tycon = Environment.array -> true
      | _ -> takes_an_array result)
  | _ -> false

let is_of_arrays ctx (name : Syntax.Ir.name) =
  let found (g : Ir.Global.t) (entry : entry) earlier =
    earlier || (String.equal g.name name.text && takes_an_array entry.scheme.body)
  in
  Resolve.Global_table.fold found ctx.globals false

(* The field of this record that is itself a record with the wanted field. *)
let field_within ctx ty name =
  let has (_, (field_type : Ir.ty)) =
    match field_type with
    | Data { tycon; _ } ->
        Option.fold (Environment.record_of ctx.reader.environment tycon) ~none:false
          ~some:(fun constructor -> position constructor name <> None)
    | _ -> false
  in
  match Type.expand ty with
  | Data { tycon; _ } ->
      Option.bind (Environment.record_of ctx.reader.environment tycon) (fun constructor ->
          Option.map fst (List.find_opt has constructor.ir.fields))
  | _ -> None

let path ctx ty name =
  let own =
    match Type.expand ty with
    | Data { tycon; _ } ->
        Option.bind (Environment.record_of ctx.reader.environment tycon) (fun constructor ->
            position constructor name)
    | _ -> None
  in
  match (own, field_within ctx ty name) with
  | Some _, _ -> Some name
  | None, Some field -> Some (field ^ "." ^ name)
  | None, None -> None

(* Handles types that do not have fields but produce values that may have some, such as signal
   functions. *)
let through ctx words (name : Syntax.Ir.name) ~(record : Resolve.Ir.expr) ty d =
  let text = Option.value (Show.quote words record.span) ~default:"x" in
  let grouped = Source.grouped text in
  let whole = Span.merge record.span name.span in
  match Type.expand ty with
  | Signal_function (input, output) ->
      let signal = Option.value (Show.signal words input) ~default:"()" in
      let applied = Printf.sprintf "%s %s" text signal in
      let has_it =
        Option.fold (Show.fields words output) ~none:false ~some:(fun (_, fields) ->
            List.mem name.text fields)
      in
      let cure = if has_it then Printf.sprintf "(%s).%s" applied name.text else applied in
      Some
        (Diagnostic.hint
           (Printf.sprintf "it is a signal function; its output %s `%s`"
              (if has_it then "has it:" else "is")
              cure)
           d
        |>
        if String.equal text grouped then
          Diagnostic.fix
            (Printf.sprintf "write `%s`" cure)
            [ (whole, if has_it then cure else "(" ^ cure ^ ")") ]
        else Fun.id)
  | t when Environment.is_event t ->
      Some
        (Diagnostic.hint
           (Printf.sprintf
              "an event has a value only when it occurs: write `mapE (\\x -> x.%s) %s` for the \
               event of its `%s`; to keep the latest value, `hold x0` that event, where `x0` is \
               the initial value"
              name.text grouped name.text)
           d)
  | Data { tycon; _ } when tycon = Environment.built_in "Maybe" ->
      Some
        (Diagnostic.hint
           (Printf.sprintf
              "the value may be missing: write `maybe x0 (\\x -> x.%s) %s`, where `x0` replaces a \
               missing value"
              name.text grouped)
           d)
  | Data { tycon; _ }
    when tycon = Environment.array && List.mem name.text [ "size"; "length"; "count"; "len" ] ->
      Some (Diagnostic.hint (Printf.sprintf "`length` is a function: write `length %s`" grouped) d)
  | Data { tycon; _ } when tycon = Environment.array && not (is_of_arrays ctx name) ->
      Some
        (Diagnostic.hint
           (Printf.sprintf
              "for the field of the first element, write `(%s ! 0).%s`; for those of all elements, \
               write `map (\\x -> x.%s) %s`"
              grouped name.text name.text grouped)
           d)
  | _ -> None

(* By convention, the names of robots' input records end in `Input`. *)
let is_an_input ty =
  match Type.expand ty with
  | Data { tycon; _ } -> String.ends_with ~suffix:"Input" tycon.name
  | _ -> false

let is_a_tuple ty = match Type.expand ty with Tuple [ _; _ ] -> true | _ -> false

(* `p.x`, where `p` is a pair of coordinates. *)
let of_a_tuple words (name : Syntax.Ir.name) (record : Resolve.Ir.expr) d =
  let elements =
    match (Bare_number.value words record).desc with
    | Tuple [ a; b ] -> (Show.quote words a.span, Show.quote words b.span)
    | _ -> (None, None)
  in
  match (name.text, elements) with
  | ("x" | "y"), (Some x, Some y) ->
      Diagnostic.hint
        (Printf.sprintf
           "a pair has no fields: write a point as `Vec2 { x = %s, y = %s }`, with `import \
            Geometry`"
           x y)
        d
  | _ ->
      Diagnostic.hint
        (Printf.sprintf "a pair has no fields: take it apart by an equation, `(a, b) = %s`"
           (Option.value (Show.quote words record.span) ~default:"p"))
        d

(* `i.scan`, where `i` is the input of a robot. *)
let of_an_input (record : Resolve.Ir.expr) d =
  let i = match record.desc with Local x -> x.name | _ -> "i" in
  Diagnostic.hint
    (Printf.sprintf
       "a robot's sensors are signal functions of its input: write `frontSonar %s` for the \
        distance in front, `sonars %s` for all sonars"
       i i)
    d

let is_input_of_a_proc ctx (record : Resolve.Ir.expr) =
  match record.desc with Local x -> List.mem_assoc x.name ctx.inputs | _ -> false

(* The constructor of this type, if it is a record type that has the field. *)
let takes_a_record words input field =
  match Show.fields words input with
  | Some (constructor, fields) when List.mem field fields -> Some constructor
  | Some _ | None -> None

(* The type of the quantity that a field of this name usually has. *)
let usual_type = function
  | "distance" | "dist" | "range" | "depth" | "length" | "d" | "r" -> Some "Float[m]"
  | "speed" | "velocity" | "vel" | "v" -> Some "Float[m/s]"
  | "time" | "stamp" | "timestamp" | "duration" | "t" -> Some "Float[s]"
  | "omega" | "turn" | "turnRate" | "angularVelocity" | "yawRate" | "w" -> Some "Float[1/s]"
  | "angle" | "bearing" | "heading" | "theta" | "direction" | "yaw" -> Some "Float"
  | "voltage" | "volts" -> Some "Float[V]"
  | _ -> None

(* The only field with the type of the quantity that the name describes. *)
let of_the_same_quantity ctx ty name =
  match (Type.expand ty, usual_type name) with
  | Data { tycon; _ }, Some type_ ->
      Option.bind (Environment.record_of ctx.reader.environment tycon) (fun constructor ->
          let is_it (_, field) = String.equal (Show.ty field) type_ in
          match List.filter is_it constructor.ir.fields with
          | [ (field, _) ] -> Some field
          | _ -> None)
  | _ -> None

let no_field ctx (name : Syntax.Ir.name) ~(record : Resolve.Ir.expr) ty known =
  report ctx (fun words ->
      let described = Show.described words ty in
      let error format = Diagnostic.error ~code:"E0310" ~at:name.span format in
      (match one_of_several ctx.reader.environment ty name.text with
      | Some { constructor; _ } ->
          error "not every %s has the field `%s`" described name.text
          |> Diagnostic.hint
               (Printf.sprintf "only `%s` has it: use a `case` with the pattern `%s { %s = x }`"
                  constructor.name constructor.name name.text)
      | None -> (
          let d = error "%s has no field `%s`" described name.text in
          let usual () =
            let begins field =
              String.length name.text > 2 && String.starts_with ~prefix:name.text field
            in
            match (Suggest.closest name.text known, known) with
            | None, _ when List.length (List.filter begins known) = 1 ->
                let field = List.find begins known in
                Diagnostic.hint (Printf.sprintf "did you mean `%s`?" field) d
                |> Diagnostic.write name.span field
            | None, _ :: _ when List.compare_length_with known 8 <= 0 -> (
                let fields = List.map (Printf.sprintf "`%s`") known in
                let d = Diagnostic.note ("its fields: " ^ String.concat ", " fields) d in
                match of_the_same_quantity ctx ty name.text with
                | Some field ->
                    Diagnostic.hint (Printf.sprintf "did you mean `%s`?" field) d
                    |> Diagnostic.write name.span field
                | None -> d)
            | _ -> suggest name known d
          in
          match (Type.expand ty, Show.quote words record.span) with
          | Function (input, _), Some f when takes_a_record words input name.text <> None ->
              let constructor = Option.get (takes_a_record words input name.text) in
              Diagnostic.hint
                (Printf.sprintf "`%s` takes the record as an argument: use `%s (%s { %s = … })`" f f
                   constructor name.text)
                d
          | Function (input, _), Some f when Show.signal words input <> None ->
              let applied = Printf.sprintf "(%s %s)" f (Option.get (Show.signal words input)) in
              let text = Printf.sprintf "%s.%s" applied name.text in
              Diagnostic.hint (Printf.sprintf "`%s` is a function: write `%s`" f text) d
              |> Diagnostic.fix (Printf.sprintf "write `%s`" text) [ (record.span, applied) ]
          | _, Some text when field_within ctx ty name.text <> None ->
              let field = Option.get (field_within ctx ty name.text) in
              let cure = Printf.sprintf "%s.%s.%s" (Source.grouped text) field name.text in
              Diagnostic.hint (Printf.sprintf "its field `%s` has it: write `%s`" field cure) d
              |> Diagnostic.fix
                   (Printf.sprintf "write `%s`" cure)
                   [ (name.span, field ^ "." ^ name.text) ]
          | _ -> (
              match through ctx words name ~record ty d with
              | Some d -> d
              | None -> (
                  match as_a_function ctx name ~record d with
                  | Some d -> d
                  | None when is_a_tuple ty -> of_a_tuple words name record d
                  | None when is_an_input ty -> of_an_input record d
                  | None -> usual ()))))
      |> Diagnostic.label ~at:record.span ("this is " ^ described))

(* Handles a record whose type is unknown, perhaps because of another error. *)
let no_such_field ctx (name : Syntax.Ir.name) ~record =
  if errors ctx = 0 then
    report ctx (fun _ ->
        let d =
          Diagnostic.error ~code:"E0310" ~at:name.span "no type in scope has a field `%s`" name.text
        in
        match as_a_function ctx name ~record d with
        | Some d -> d
        | None when is_input_of_a_proc ctx record -> of_an_input record d
        | None -> suggest name (Environment.field_names ctx.reader.environment) d)

let several_records ctx (name : Syntax.Ir.name) ~(record : Resolve.Ir.expr) candidates =
  report ctx (fun _ ->
      let names = List.map (fun (g : Ir.Global.t) -> "`" ^ g.name ^ "`") candidates in
      Diagnostic.error ~code:"E0311" ~at:name.span
        "several types have a field `%s`, and nothing determines which one you mean" name.text
      |> Diagnostic.label ~at:record.span "the type of this is unknown"
      |> Diagnostic.note ("types with such a field: " ^ String.concat ", " names)
      |> Diagnostic.hint "give the definition a signature")

(* Waits until the record's type is known, then calls [found] with its constructor, or with [None]
   after reporting an error. *)
let when_known ctx ~(record : Resolve.Ir.expr) ty (fields : Syntax.Ir.name list) ~candidates
    (found : Environment.constructor option -> unit) =
  match fields with
  | [] -> found None
  | first :: _ ->
      let environment = ctx.reader.environment in
      let attempt () =
        match Type.expand ty with
        | Flexible _ -> false
        | Data { tycon; _ } as ty ->
            (match Environment.record_of environment tycon with
            | None ->
                no_field ctx first ~record ty [];
                found None
            | Some constructor -> (
                let missing =
                  List.find_opt
                    (fun (f : Syntax.Ir.name) -> position constructor f.text = None)
                    fields
                in
                match missing with
                | None -> found (Some constructor)
                | Some name ->
                    no_field ctx name ~record ty (List.map fst constructor.ir.fields);
                    found None));
            true
        | Erroneous ->
            found None;
            true
        | ( Rigid _ | Number _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Size _
          | Alias _ ) as ty ->
            no_field ctx first ~record ty [];
            found None;
            true
      in
      let guess () =
        match candidates with
        | [ only ] -> (
            match Environment.record_of environment only with
            | Some constructor ->
                ignore (field_types ctx constructor ~at:record.span ty);
                attempt ()
            | None -> false)
        | _ -> false
      in
      let give_up () =
        (match candidates with
        | [] -> no_such_field ctx first ~record
        | _ when errors ctx > 0 -> ()
        | _ -> several_records ctx first ~record candidates);
        found None
      in
      ask ctx { attempt; guess; give_up }

let decided ctx = function
  | { contents = Some answer } -> answer
  | { contents = None } ->
      Diagnostic.bug ~stage:"Typing.Infer_record" "a field was not decided (%d errors)" (errors ctx)

let indexed (constructor : Environment.constructor) (name : Syntax.Ir.name) =
  match position constructor name.text with
  | Some index -> index
  | None ->
      Diagnostic.bug ~stage:"Typing.Infer_record" "%s has no field %s"
        constructor.ir.constructor.name name.text

(* Describes how the units of the fields are related. *)
let in_units (constructor : Environment.constructor) =
  let field (name, ty) =
    match (ty : Ir.ty) with
    | Number (_, u) -> Some (Printf.sprintf "`%s` has `%s`" name (Show.unit_ u))
    | _ -> None
  in
  Printf.sprintf "in a `%s`, the units depend on each other: %s" constructor.tycon.name
    (String.concat ", " (List.filter_map field constructor.ir.fields))

(* The number that a field is set to, with the place of the digits. *)
let rec number (e : Resolve.Ir.expr) =
  match e.desc with
  | Number { digits; unit_; _ } -> Some (false, digits, unit_, e.span)
  | Negate e ->
      Option.map (fun (negative, digits, unit_, at) -> (not negative, digits, unit_, at)) (number e)
  | _ -> None

(* `Pid[m, m/s]` (u is `m`, v is `m/s`). *)
let with_unit_variables words (constructor : Environment.constructor) ty units =
  let variable ({ variable = v; _ } : Units.rigid) u =
    Printf.sprintf "%s is `%s`" v.name (Show.measure words u)
  in
  Printf.sprintf "`%s` (%s)" (Show.type_ words ty)
    (String.concat ", " (List.map2 variable constructor.scheme.units units))

(* The whole record with a unit after each number. If there is no [wanted] type, the units that the
   program writes determine those of the type; units that remain open become `m` and `m/s`, as
   examples. *)
let with_units ctx (constructor : Environment.constructor) ?wanted fields =
  let environment = ctx.reader.environment in
  let instance = Type.instantiate ctx.reader.supply ~depth:ctx.depth constructor.scheme in
  let types, result = Environment.fields constructor instance.ty in
  Option.iter (fun wanted -> ignore (Unify.types wanted result)) wanted;
  let words = words ctx in
  let unit_of (name : Syntax.Ir.name) =
    match Option.map (fun i -> Type.expand (List.nth types i)) (position constructor name.text) with
    | Some (Type.Number (_, u)) -> Some u
    | Some _ | None -> None
  in
  let numbers = List.map (fun (name, e) -> (name, number e, unit_of name)) fields in
  let by_written (_, number, unit_) =
    match (number, unit_) with
    | Some (_, _, Some written, _), Some u ->
        Option.iter
          (fun written -> ignore (Units.unify u written))
          (Show.unit_written words written)
    | _ -> ()
  in
  List.iter by_written numbers;
  let base name = (Environment.unit_ environment (Environment.built_in name)).measure in
  let units = match Type.expand result with Data { units; _ } -> units | _ -> [] in
  let is_example = List.exists Units.is_open units in
  let choose i u =
    if Units.is_open u then
      ignore (Units.unify u (if i = 0 then base "m" else Units.divide (base "m") (base "s")))
  in
  List.iteri choose units;
  let field ((name : Syntax.Ir.name), number, unit_) =
    match (number, unit_) with
    | Some (negative, digits, written, at), Some u when not (Units.is_open u) ->
        let measure = Show.measure words u in
        let is_zero = float_of_string_opt digits = Some 0. in
        let literal =
          if is_zero || String.equal measure "1" then digits
          else Printf.sprintf "%s[%s]" digits measure
        in
        let is_right =
          match Option.bind written (Show.unit_written words) with
          | Some unit_ -> Units.equal unit_ u
          | None -> String.equal literal digits
        in
        (* a right unit stays as it is written: `60[deg/s]` is not `60[1/s]` *)
        let literal =
          if is_right then Option.value (Show.quote words at) ~default:literal else literal
        in
        let edit = if is_right then None else Some (at, literal) in
        Some (Printf.sprintf "%s = %s%s" name.text (if negative then "-" else "") literal, edit)
    | _ -> None
  in
  let written = List.map field numbers in
  if List.mem None written || List.exists Units.is_open units then None
  else
    let all = List.filter_map Fun.id written in
    let record =
      Printf.sprintf "%s { %s }" constructor.ir.constructor.name
        (String.concat ", " (List.map fst all))
    in
    let text =
      Printf.sprintf "give all its numbers their units: for a %s%s, write `%s`"
        (with_unit_variables words constructor result units)
        (if is_example then ", for example" else "")
        record
    in
    Some (text, List.filter_map snd all)

let construct expressions ctx ?wanted (e : Resolve.Ir.expr) name fields =
  let constructor = Environment.constructor ctx.reader.environment name in
  let ty, _ = use ctx ~at:e.span ~name:name.name constructor.scheme in
  let types, result = Environment.fields constructor ty in
  (* the caller reports a mismatch *)
  Option.iter (fun wanted -> ignore (Unify.types wanted result)) wanted;
  let types = Array.of_list types in
  let before = errors ctx in
  let several = List.compare_length_with constructor.scheme.units 1 > 0 in
  let units = if several then Some (in_units constructor) else None in
  (* if wanted units are still open, the wrong numbers would determine them *)
  let wanted =
    match Option.map Type.expand wanted with
    | Some (Type.Data { units; _ } as t) when not (List.exists Units.is_open units) -> Some t
    | Some _ | None -> None
  in
  let whole value =
    match number value with
    | Some (_, _, written, _) when several && (written = None || wanted <> None) ->
        lazy (with_units ctx constructor ?wanted fields)
    | _ -> lazy None
  in
  let field ((name : Syntax.Ir.name), value) =
    let index = indexed constructor name in
    (* after one field with a wrong unit, the others would seem wrong too *)
    let ty = if several && errors ctx > before then Type.Erroneous else types.(index) in
    let because = Expected.Field { name = name.text; at = name.span; units; whole = whole value } in
    (index, expressions.check ctx value { ty; because })
  in
  let fields = List.map field fields in
  let result = if several && errors ctx > before then Type.Erroneous else result in
  let build () =
    node e.span result
      (Record (constructor.ir, List.map (fun (index, build) -> (index, build ())) fields))
  in
  { ty = result; build }

(* `robotPose i.heading`, which was meant as a field of `robotPose i`. *)
let tell_tighter ctx (e : Resolve.Ir.expr) ~(record : Resolve.Ir.expr) (name : Syntax.Ir.name) ~by =
  report ctx (fun words ->
      let function_ = String.concat "" (String.split_on_char '`' by) in
      let record = Option.value (Show.quote words record.span) ~default:"r" in
      Diagnostic.error ~code:"E0310" ~at:e.span
        "a field binds tighter than application: this is a field of `%s`" record
      |> Diagnostic.hint
           (Printf.sprintf "for a field of the result of `%s`, write `(%s %s).%s`" function_
              function_ record name.text))

let field expressions ctx (e : Resolve.Ir.expr) ~record (name : Syntax.Ir.name) ~candidates =
  let typed = expressions.infer ctx record in
  let result = Context.fresh ctx in
  let answer = ref None in
  when_known ctx ~record typed.ty [ name ] ~candidates (fun constructor ->
      let ty =
        match constructor with
        | None -> Type.Erroneous
        | Some constructor ->
            field_type ctx constructor ~at:e.span typed.ty (indexed constructor name)
      in
      answer := Some constructor;
      match asked_in_vain ctx ~wanted:ty result with
      | Some by ->
          tell_tighter ctx e ~record name ~by;
          expect ctx ~at:e.span { ty = result; because = Unknown } Type.Erroneous
      | None -> expect ctx ~subject:e ~at:e.span { ty = result; because = Unknown } ty);
  let build () =
    node e.span result
      (match decided ctx answer with
      | Some constructor -> Field (typed.build (), constructor.ir, indexed constructor name)
      | None -> Tuple [])
  in
  { ty = result; build }

let update expressions ctx (e : Resolve.Ir.expr) ~record fields ~candidates =
  let typed = expressions.infer ctx record in
  let values =
    List.map
      (fun ((name : Syntax.Ir.name), value) ->
        let ty = Context.fresh ctx in
        (name, value, ty))
      fields
  in
  let answer = ref None in
  (* If the record's type is known now, its field types guide the inference of the values. *)
  when_known ctx ~record typed.ty (List.map fst fields) ~candidates (fun constructor ->
      answer := Some constructor;
      let types =
        match constructor with
        | Some constructor ->
            let types = field_types ctx constructor ~at:e.span typed.ty in
            let types = Array.of_list types in
            fun name -> types.(indexed constructor name)
        | None -> fun _ -> Type.Erroneous
      in
      List.iter
        (fun ((name : Syntax.Ir.name), (value : Resolve.Ir.expr), ty) ->
          expect ctx ~subject:value ~at:value.span
            {
              ty = types name;
              because = Field { name = name.text; at = name.span; units = None; whole = lazy None };
            }
            ty)
        values);
  let values =
    List.map
      (fun ((name : Syntax.Ir.name), value, ty) ->
        let because =
          Expected.Field { name = name.text; at = name.span; units = None; whole = lazy None }
        in
        (name, expressions.check ctx value { ty; because }))
      values
  in
  let build () =
    node e.span typed.ty
      (match decided ctx answer with
      | Some constructor ->
          Update
            ( typed.build (),
              constructor.ir,
              List.map (fun (name, build) -> (indexed constructor name, build ())) values )
      | None -> Tuple [])
  in
  { ty = typed.ty; build }
