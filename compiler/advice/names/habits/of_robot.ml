open Basis

type hint = {
  text : string;
  edit : (Span.t * string) option;
  is_certain : bool;  (** takes precedence over a similar name *)
}

let plain text = { text; edit = None; is_certain = false }
let is_a_word name = Phrasebook.find Robot name <> None

(* The name of a sensor in another language, applied to the input: `speed i`. *)
let of_a_reading (t : Unknown.t) =
  match Name_in_text.application ~text:(Unknown.text t) t.name.span with
  | Some (whole, ([ ("i" | "input") ] as input)) ->
      Option.map
        (fun (text, _) ->
          { text = Printf.sprintf "write `%s`" text; edit = Some (whole, text); is_certain = true })
        (Phrasebook.applied Reading t.name.text input)
  | Some _ | None -> None

(* The variables whose previous value this name may denote: `v` for `v_prev` and `prevV`. *)
let current name =
  let n = String.length name in
  let without_end suffix =
    if String.ends_with ~suffix name && n > String.length suffix then
      Some (String.sub name 0 (n - String.length suffix))
    else None
  in
  let without_start prefix =
    let k = String.length prefix in
    if String.starts_with ~prefix name && n > k then
      Some (String.uncapitalize_ascii (String.sub name k (n - k)))
    else None
  in
  List.filter_map without_end
    [ "_prev"; "_old"; "_last"; "_previous"; "Prev"; "Old"; "Last"; "Previous" ]
  @ List.filter_map without_start
      [ "prev_"; "old_"; "last_"; "previous_"; "prev"; "old"; "last"; "previous" ]

(* `v_prev`, `prevV` or `lastV`, if `v` is known *)
let of_a_previous_value (t : Unknown.t) =
  let own = t.module_.visible.own.values in
  let is_signal base = List.mem base (Lazy.force t.locals) || String_table.mem own base in
  Option.map
    (fun base ->
      let text =
        Printf.sprintf
          "for the value of `%s` one instant ago, write `delay 0 %s`, where 0 is the initial value"
          base base
      in
      { text; edit = None; is_certain = true })
    (List.find_opt is_signal (current t.name.text))

let of_an_index (t : Unknown.t) =
  if Name_in_text.is_index ~text:(Unknown.text t) t.name.span then
    Some
      (plain
         "for the value of a signal `x` one instant ago, write `delay 0 x`, where 0 is the initial \
          value")
  else None

(* `roMake (setSpeed 0.3[m/s] 0)`, with the arguments of [setVelTR] *)
let of_speeds (t : Unknown.t) =
  let source = Unknown.text t in
  if not (Name_in_text.follows ~text:source "roMake (" t.name.span) then None
  else
    Option.bind (Name_in_text.application ~text:source t.name.span) @@ fun (whole, arguments) ->
    Option.map
      (fun (text, _) ->
        {
          text = Printf.sprintf "write `%s`, which sets the speed and the turn rate" text;
          edit = Some (whole, text);
          is_certain = true;
        })
      (Phrasebook.applied Speed t.name.text arguments)

let of_a_word (t : Unknown.t) =
  Option.map (fun row -> plain (Phrasebook.hint row)) (Phrasebook.find Robot t.name.text)

let of_the_input (t : Unknown.t) =
  match t.name.text with
  | "i" | "input" | "sensors" ->
      Some
        (plain
           "only a `proc` can name the robot's input, as in `proc i -> …`; in a task, write `d <- \
            ask frontSonar` to read a sensor once")
  | _ -> None

let rules = [ of_the_input; of_a_reading; of_a_previous_value; of_an_index; of_speeds; of_a_word ]

(* `a'` for the transpose of a matrix `a` *)
let transposed (t : Unknown.t) =
  let name = t.name.text in
  let base = String.sub name 0 (max 0 (String.length name - 1)) in
  let signature () =
    Option.value (Name_in_text.signature ~text:(Unknown.text t) t.name.span) ~default:""
  in
  let imports_matrices =
    List.exists
      (fun (i : Resolve.Visible.import) -> String.equal i.module_ "Matrix")
      t.module_.visible.imports
  in
  if
    t.namespace = Values && String.ends_with ~suffix:"'" name
    && List.mem base (Lazy.force t.names)
    && (imports_matrices
       || List.exists
            (fun word -> List.mem word (String.split_on_char ' ' (signature ())))
            [ "Matrix"; "(Array" ])
  then
    let transpose = Printf.sprintf "(transpose %s)" base in
    let at, text =
      match Name_in_text.product ~text:(Unknown.text t) t.name.span with
      | Some (whole, first, second) ->
          let matrix text = if String.equal text name then transpose else text in
          (whole, Printf.sprintf "matMul %s %s" (matrix first) (matrix second))
      | None -> (t.name.span, transpose)
    in
    Printf.sprintf
      "`'` is part of the name: for the transpose of `%s`, write `%s`, with `import Matrix`" base
      text
    |> Imports.without_imported t.module_.visible
    |> fun hint ->
    Some (Diagnostic.hint "%s" hint (Other_meaning.diagnostic t) |> Diagnostic.write at text)
  else None

let diagnostic suggestions (t : Unknown.t) =
  match transposed t with
  | Some diagnostic -> diagnostic
  | None -> (
      let diagnostic = Other_meaning.diagnostic t in
      let suggested = Suggestion.add suggestions t.name.text t.names diagnostic in
      let hint = if t.namespace = Values then List.find_map (fun rule -> rule t) rules else None in
      match hint with
      | Some { text; edit; is_certain } when is_certain || suggested.hints = [] ->
          Diagnostic.hint "%s" text diagnostic
          |> Option.fold edit ~none:Fun.id ~some:(fun (at, text) -> Diagnostic.write at text)
      | Some _ | None -> suggested)
