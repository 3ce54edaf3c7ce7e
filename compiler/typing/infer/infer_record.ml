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
                tell ctx (Missing_field { field = first; record; ty; known = [] });
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
                    let known = List.map fst constructor.ir.fields in
                    tell ctx (Missing_field { field = name; record; ty; known });
                    found None));
            true
        | Erroneous ->
            found None;
            true
        | ( Rigid _ | Number _ | Bool | String | Tuple _ | Function _ | Signal_function _ | Size _
          | Alias _ ) as ty ->
            tell ctx (Missing_field { field = first; record; ty; known = [] });
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
        | _ when errors ctx > 0 -> ()
        | [] -> tell ctx (Unknown_field { field = first; record })
        | types -> tell ctx (Ambiguous_field { field = first; record; types }));
        found None
      in
      ask ctx { attempt; guess; give_up }

let decided ctx = function
  | { contents = Some answer } -> answer
  | { contents = None } ->
      Diagnostic.bug ~stage:"Typing.Infer_record"
        "the record of a field is undetermined (%d errors)" (errors ctx)

let indexed (constructor : Environment.constructor) (name : Syntax.Ir.name) =
  match position constructor name.text with
  | Some index -> index
  | None ->
      Diagnostic.bug ~stage:"Typing.Infer_record" "%s has no field %s"
        constructor.ir.constructor.name name.text

let rec number (e : Resolve.Ir.expr) : Expected.number option =
  match e.desc with
  | Number { digits; unit_; _ } -> Some { negative = false; digits; unit_; at = e.span }
  | Negate e ->
      Option.map (fun (n : Expected.number) -> { n with negative = not n.negative }) (number e)
  | _ -> None

(* Completes the record with units, for a message. If there is no [wanted] type, the units written
   in the program determine the units of the type. Units that remain undetermined become `m` and
   `m/s`, as examples. *)
let completed ctx (constructor : Environment.constructor) ?wanted fields : Expected.completed =
  let environment = ctx.reader.environment in
  let instance = Type.instantiate ctx.reader.supply ~depth:ctx.depth constructor.scheme in
  let types, ty = Environment.fields constructor instance.ty in
  Option.iter (fun wanted -> ignore (Unify.types wanted ty)) wanted;
  let unit_of (name : Syntax.Ir.name) =
    match Option.map (fun i -> Type.expand (List.nth types i)) (position constructor name.text) with
    | Some (Type.Number (_, u)) -> Some u
    | Some _ | None -> None
  in
  let fields = List.map (fun (name, e) -> (name, number e, unit_of name)) fields in
  let by_written (_, (number : Expected.number option), unit_) =
    match (number, unit_) with
    | Some { unit_ = Some written; _ }, Some u ->
        Option.iter (fun written -> ignore (Units.unify u written)) (written_unit ctx written)
    | _ -> ()
  in
  List.iter by_written fields;
  let base name = (Environment.unit_ environment (Environment.built_in name)).measure in
  let units = match Type.expand ty with Data { units; _ } -> units | _ -> [] in
  let is_example = List.exists Units.is_open units in
  let choose i u =
    if Units.is_open u then
      ignore (Units.unify u (if i = 0 then base "m" else Units.divide (base "m") (base "s")))
  in
  List.iteri choose units;
  { ty; units; is_example; fields }

let construct expressions ctx ?wanted (e : Resolve.Ir.expr) name fields =
  let constructor = Environment.constructor ctx.reader.environment name in
  let ty, _ = use ctx ~at:e.span ~name:name.name constructor.scheme in
  let types, result = Environment.fields constructor ty in
  (* the caller reports any mismatch *)
  Option.iter (fun wanted -> ignore (Unify.types wanted result)) wanted;
  let types = Array.of_list types in
  let before = errors ctx in
  let several = List.compare_length_with constructor.scheme.units 1 > 0 in
  (* a wanted type with undetermined units is ignored, because wrong numbers would determine these
     units *)
  let wanted =
    match Option.map Type.expand wanted with
    | Some (Type.Data { units; _ } as t) when not (List.exists Units.is_open units) -> Some t
    | Some _ | None -> None
  in
  let completed value =
    match number value with
    | Some { unit_; _ } when several && (unit_ = None || wanted <> None) ->
        Some (lazy (completed ctx constructor ?wanted fields))
    | _ -> None
  in
  let field ((name : Syntax.Ir.name), value) =
    let index = indexed constructor name in
    (* after one field with a wrong unit, the units of the others would seem wrong, too *)
    let ty = if several && errors ctx > before then Type.Erroneous else types.(index) in
    let because =
      Expected.Field
        {
          name = name.text;
          at = name.span;
          constructor = (if several then Some constructor else None);
          completed = completed value;
        }
    in
    (index, expressions.check ctx value { ty; because; parts = [] })
  in
  let fields = List.map field fields in
  let result = if several && errors ctx > before then Type.Erroneous else result in
  let build () =
    node e.span result
      (Record (constructor.ir, List.map (fun (index, build) -> (index, build ())) fields))
  in
  { ty = result; build }

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
          tell ctx (Field_of_argument { at = e.span; field = name; record; function_ = by });
          expect ctx ~at:e.span { ty = result; because = Unknown; parts = [] } Type.Erroneous
      | None -> expect ctx ~subject:e ~at:e.span { ty = result; because = Unknown; parts = [] } ty);
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
              because =
                Field { name = name.text; at = name.span; constructor = None; completed = None };
              parts = [];
            }
            ty)
        values);
  let values =
    List.map
      (fun ((name : Syntax.Ir.name), value, ty) ->
        let because =
          Expected.Field { name = name.text; at = name.span; constructor = None; completed = None }
        in
        (name, expressions.check ctx value { ty; because; parts = [] }))
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
