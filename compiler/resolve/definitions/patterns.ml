open Basis
open Interface

let number scope (n : Syntax.Ir.number) : Ir.number =
  { digits = n.digits; decimal = n.decimal; unit_ = Option.map (Types.concrete_unit scope) n.unit_ }

let report (scope : Scope.t) = Context.report_record scope.context

let construction (scope : Scope.t) (constructor : constructor) ~at given =
  match constructor.fields with
  | None ->
      report scope (No_fields { constructor; at });
      None
  | Some known ->
      let known_set = String_set.of_list known in
      let wrong = ref [] in
      let add (seen, reversed) ((field : Syntax.Ir.name), x) =
        match String_map.find_opt field.text seen with
        | Some first ->
            report scope (Field_repeated { first; second = field });
            (seen, reversed)
        | None when String_set.mem field.text known_set ->
            (String_map.add field.text field seen, (field, x) :: reversed)
        | None ->
            wrong := field :: !wrong;
            (seen, reversed)
      in
      let given = List.rev (snd (List.fold_left add (String_map.empty, []) given)) in
      (match List.rev !wrong with
      | [] -> ()
      | first :: others -> report scope (Unknown_fields { constructor; known; first; others }));
      Some given

let rec pattern (scope : Scope.t) (p : Syntax.Ir.pattern) : Ir.pattern =
  let any : Ir.pattern = { desc = Any; span = p.span } in
  Context.nested scope.context p.span ~otherwise:any (fun () -> { any with desc = desc scope p })

and desc scope (p : Syntax.Ir.pattern) : Ir.pattern_desc =
  match p.desc with
  | Any -> Any
  | Bound name -> Bound (Context.fresh scope.context name.text name.span)
  | As (name, inner) ->
      let local = Context.fresh scope.context name.text name.span in
      As (local, pattern scope inner)
  | Tuple_of ps -> Tuple_of (Long_list.map (pattern scope) ps)
  | Array_of ps -> Array_of (Long_list.map (pattern scope) ps)
  | Literal { negative; number = n } -> Literal { negative; number = number scope n }
  | Constructed (name, arguments) -> (
      let arguments = Long_list.map (pattern scope) arguments in
      match Lookup.find scope constructors name with
      | None -> Tuple_of arguments
      | Some constructor ->
          let found = List.length arguments in
          if found <> constructor.arity then
            report scope (Wrong_number_of_arguments { constructor; at = p.span; found });
          Constructed (constructor.global, arguments))
  | Record_of (name, given) -> (
      let given = Long_list.map (fun (field, inner) -> (field, pattern scope inner)) given in
      match Lookup.find scope constructors name with
      | None -> Tuple_of (Long_list.map snd given)
      | Some constructor -> positional scope constructor p.span given)

and positional scope constructor span all : Ir.pattern_desc =
  let given = Option.value (construction scope constructor ~at:span all) ~default:[] in
  let add by_name ((field : Syntax.Ir.name), p) = String_map.add field.text p by_name in
  let by_name = List.fold_left add String_map.empty given in
  let argument field =
    Option.value (String_map.find_opt field by_name) ~default:({ desc = Any; span } : Ir.pattern)
  in
  let arguments = Long_list.map argument (Option.value constructor.fields ~default:[]) in
  (* An erroneous field remains in the pattern, so that its variables are bound. *)
  let faulty = List.filter (fun (field, _) -> not (List.mem_assq field given)) all in
  Constructed (constructor.global, arguments @ Long_list.map snd faulty)

let variables p =
  let rec add found (p : Ir.pattern) =
    match p.desc with
    | Any | Literal _ -> found
    | Bound local -> local :: found
    | As (local, inner) -> add (local :: found) inner
    | Tuple_of ps | Array_of ps | Constructed (_, ps) -> List.fold_left add found ps
  in
  List.rev (add [] p)

let bind env patterns =
  let patterns = Long_list.map (pattern (Env.scope env)) patterns in
  let variable local : Env.variable = { local; owner = None } in
  let locals = List.concat_map (fun p -> Long_list.map variable (variables p)) patterns in
  (Env.bind env locals, patterns)
