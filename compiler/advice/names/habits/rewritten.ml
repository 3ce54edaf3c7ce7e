open Basis

let application (t : Unknown.t) = Name_in_text.application ~text:(Unknown.text t) t.name.span
let follows (t : Unknown.t) before = Name_in_text.follows ~text:(Unknown.text t) before t.name.span

let unit_after_number (t : Unknown.t) =
  if t.namespace = Values && Unknown.is_unit t t.name.text then
    Name_in_text.unit_after_number ~text:(Unknown.text t) ~is_unit:(Unknown.is_unit t) t.name.span
  else None

(* `pow v 2`, with the arguments of Frob and the name of another language. *)
let power_in_text (t : Unknown.t) =
  match (t.name.text, application t) with
  | ("pow" | "powf"), Some (whole, [ base; exponent ]) ->
      Other_notation.expression (Printf.sprintf "pow(%s, %s)" base exponent)
      |> Option.map (fun text -> (whole, text))
  | _ -> None

let is_time_step name = List.mem name [ "dt"; "deltaTime"; "delta_t" ]

let integral (t : Unknown.t) =
  if t.namespace <> Values || not (is_time_step t.name.text) then None
  else
    Option.bind
      (Name_in_text.assigned ~text:(Unknown.text t) t.name.span)
      (fun (x, right, place) ->
        Option.map (fun integral -> (x, integral, place)) (Own_equation.integral ~name:x right))

(* `(x - xBefore) / dt` *)
let rate_in_text (t : Unknown.t) =
  if not (is_time_step t.name.text) then None
  else
    Option.map
      (fun (whole, x) -> (whole, "derivative " ^ x))
      (Name_in_text.divided_difference ~text:(Unknown.text t) t.name.span)

(* `len a`, as a factor or divisor of Floats *)
let length_in_text (t : Unknown.t) =
  match (t.name.text, application t) with
  | ("len" | "sizeof"), Some (whole, [ argument ]) ->
      let text = "length " ^ argument in
      let is_factor = List.exists (follows t) [ "/ "; "* " ] in
      Some (whole, if is_factor then Printf.sprintf "toFloat (%s)" text else text)
  | _ -> None

(* The name after the point, as in `math.sin`, and the place of both. *)
let field (t : Unknown.t) =
  Option.map
    (fun (whole : Span.t) ->
      let n = Span.column whole.stop - Span.column t.name.span.stop - 1 in
      let line =
        List.nth (String.split_on_char '\n' (Unknown.text t)) (Span.line whole.start - 1)
      in
      (whole, String.sub line (Span.column t.name.span.stop) n))
    (Name_in_text.field ~text:(Unknown.text t) t.name.span)

(* `math.sin x`, `np.linalg.norm v` or `math.pi`, which are parsed as fields of `math` *)
let of_a_module ~text (name : Syntax.Ir.name) =
  let open Basis.Let_syntax.Option in
  let* whole = Name_in_text.member ~text name.span in
  let* member = Other_function.without_module (Name_in_text.written ~text whole) in
  match (Other_function.constant member, Name_in_text.call ~text whole) with
  | Some text, _ -> Some (whole, text)
  | None, Some (at, text) -> Some (at, text)
  | None, None -> (
      match Name_in_text.application ~text whole with
      | Some (at, arguments) when not (Name_in_text.is_an_argument ~text name.span) ->
          let arguments = List.map (Name_in_text.without_modules name.text) arguments in
          let* text = Other_function.applied member arguments in
          Some (at, text)
      | Some _ | None ->
          let* text = Other_function.alone member in
          Some (whole, text))

let of_module (t : Unknown.t) = of_a_module ~text:(Unknown.text t) t.name

(* `fmap f e` or `filter f e`, where the signature contains only one kind of container, and
   `length (filter f xs)` *)
let of_a_container (t : Unknown.t) =
  let words =
    Option.fold
      (Name_in_text.signature ~text:(Unknown.text t) t.name.span)
      ~none:[]
      ~some:(fun line ->
        String.split_on_char ' ' (String.map (fun c -> if Character.is_name c then c else ' ') line))
  in
  let kinds = List.filter (fun kind -> List.mem kind words) [ "Array"; "Event"; "Task" ] in
  match (Other_languages.of_each t.name.text, kinds) with
  | Some choices, [ kind ] ->
      Option.map (fun text -> (t.name.span, text)) (List.assoc_opt kind choices)
  | _ -> None

let counted_in_text (t : Unknown.t) =
  match application t with
  | Some (whole, ([ _; _ ] as arguments))
    when String.equal t.name.text "filter" && follows t "length (" ->
      let back n (p : Span.position) =
        Span.position ~line:(Span.line p) ~column:(Span.column p + n)
      in
      let whole =
        Span.make ~file:whole.file
          ~start:(back (-String.length "length (") whole.start)
          ~stop:(back 1 whole.stop)
      in
      Some (whole, String.concat " " ("countWhere" :: arguments))
  | Some _ | None -> None

(* `constrain x 0 255`, with the arguments in the order of Frob *)
let applied_in_text (t : Unknown.t) =
  Option.bind (application t) (fun (whole, arguments) ->
      Option.map (fun (text, _) -> (whole, text)) (Other_languages.applied t.name.text arguments))

let member (t : Unknown.t) =
  if t.namespace = Values && Other_languages.is_an_object t.name.text then field t else None

let import_of (t : Unknown.t) text =
  let module_ =
    match application t with
    | Some (_, arguments) -> Option.bind (Other_languages.applied t.name.text arguments) snd
    | None -> None
  in
  match module_ with
  | Some module_ -> Printf.sprintf ", with `import %s`" module_
  | None when String.starts_with ~prefix:"clamp " text -> ", with `import Control`"
  | None when String.starts_with ~prefix:"countWhere " text -> ", with `import Arrays`"
  | None when String.starts_with ~prefix:"delay 0 " text ->
      ", where 0 is the value at the first instant"
  | None when String.starts_with ~prefix:"sleepT " text -> ": the robot rests meanwhile"
  | None when of_module t <> None -> Printf.sprintf ", without `%s.`" t.name.text
  | None -> ""

let controller (t : Unknown.t) =
  match application t with
  | Some (_, [ kp; ki; kd; e ]) when Other_languages.is_of_gains t.name.text ->
      Some (Printf.sprintf "pid (Pid { kp = %s, ki = %s, kd = %s, largest = … }) %s" kp ki kd e)
  | Some _ | None -> None

let call (t : Unknown.t) =
  let in_parentheses (t : Unknown.t) = Name_in_text.call ~text:(Unknown.text t) t.name.span in
  if t.namespace <> Values then None
  else
    List.find_map
      (fun rule -> rule t)
      [
        in_parentheses;
        power_in_text;
        length_in_text;
        rate_in_text;
        of_module;
        counted_in_text;
        of_a_container;
        applied_in_text;
      ]
