open Basis
open Interface

let number scope (n : Syntax.Ir.number) : Ir.number =
  { digits = n.digits; decimal = n.decimal; unit_ = Option.map (Types.concrete_unit scope) n.unit_ }

let report_field (scope : Scope.t) (constructor : constructor) known (field : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0209" ~at:field.span "constructor `%s` has no field `%s`"
    constructor.global.name field.text
  |> Diagnostic.label ~at:constructor.span "declared here"
  |> Context.suggest scope.context field.text (lazy known)
  |> (fun d ->
  if d.hints = [] then
    Diagnostic.note ("its fields: " ^ String.concat ", " (List.map (Printf.sprintf "`%s`") known)) d
  else d)
  |> Context.emit scope.context

(* Several unknown fields are reported once: the user probably meant another record. *)
let report_fields (scope : Scope.t) (constructor : constructor) known = function
  | [] -> ()
  | [ field ] -> report_field scope constructor known field
  | (first : Syntax.Ir.name) :: _ as fields ->
      let quoted (field : Syntax.Ir.name) = Printf.sprintf "`%s`" field.text in
      Diagnostic.error ~code:"E0209" ~at:first.span "constructor `%s` has no fields %s"
        constructor.global.name
        (Enumeration.all (List.map quoted fields))
      |> Diagnostic.label ~at:constructor.span "declared here"
      |> (if List.compare_length_with known 8 <= 0 then
            Diagnostic.hint
              (Printf.sprintf "its fields are `%s { %s }`" constructor.global.name
                 (String.concat ", " (List.map (Printf.sprintf "%s = …") known)))
          else
            Diagnostic.note
              ("its fields: " ^ String.concat ", " (List.map (Printf.sprintf "`%s`") known)))
      |> Context.emit scope.context

let report_repeated (scope : Scope.t) (first : Syntax.Ir.name) (second : Syntax.Ir.name) =
  Diagnostic.error ~code:"E0213" ~at:second.span "field `%s` appears twice" second.text
  |> Diagnostic.label ~at:first.span "first used here"
  |> Context.emit scope.context

let construction (scope : Scope.t) (constructor : constructor) ~at given =
  match constructor.fields with
  | None ->
      Diagnostic.error ~code:"E0209" ~at "constructor `%s` has no named fields"
        constructor.global.name
      |> Diagnostic.label ~at:constructor.span "declared here"
      |> Context.emit scope.context;
      None
  | Some known ->
      let known_set = String_set.of_list known in
      let wrong = ref [] in
      let add (seen, reversed) ((field : Syntax.Ir.name), x) =
        match String_map.find_opt field.text seen with
        | Some first ->
            report_repeated scope first field;
            (seen, reversed)
        | None when String_set.mem field.text known_set ->
            (String_map.add field.text field seen, (field, x) :: reversed)
        | None ->
            wrong := field :: !wrong;
            (seen, reversed)
      in
      let given = List.rev (snd (List.fold_left add (String_map.empty, []) given)) in
      report_fields scope constructor known (List.rev !wrong);
      Some given

let report_arity (scope : Scope.t) (constructor : constructor) ~found at =
  Diagnostic.error ~code:"E0225" ~at "constructor `%s` has %d argument%s, not %d"
    constructor.global.name constructor.arity
    (if constructor.arity = 1 then "" else "s")
    found
  |> Diagnostic.label ~at:constructor.span "declared here"
  |> (if constructor.arity = 0 || constructor.arity > 3 then Fun.id
      else
        let name i = String.make 1 (Char.chr (Char.code 'a' + i)) in
        Diagnostic.hint
          (Printf.sprintf "its pattern is `%s %s`: write `_` for an argument that you do not use"
             constructor.global.name
             (String.concat " " (List.init constructor.arity name))))
  |> Context.emit scope.context

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
          if found <> constructor.arity then report_arity scope constructor ~found p.span;
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
