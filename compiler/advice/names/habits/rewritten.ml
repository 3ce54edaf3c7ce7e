open Basis

let application (t : Unknown.t) = Name_in_text.application ~text:(Unknown.text t) t.name.span
let follows (t : Unknown.t) before = Name_in_text.follows ~text:(Unknown.text t) before t.name.span

let unit_after_number (t : Unknown.t) =
  if t.namespace = Values && Unknown.is_unit t t.name.text then
    Name_in_text.unit_after_number ~text:(Unknown.text t) ~is_unit:(Unknown.is_unit t) t.name.span
  else None

(* `pow v 2`, applied as in Frob, but with the name from another language. *)
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

(* `len a`, converted to a Float if it follows `/` or `*` *)
let length_in_text (t : Unknown.t) =
  match (t.name.text, application t) with
  | ("len" | "sizeof"), Some (whole, [ argument ]) ->
      let text = "length " ^ argument in
      let is_factor = List.exists (follows t) [ "/ "; "* " ] in
      Some (whole, if is_factor then Printf.sprintf "toFloat (%s)" text else text)
  | _ -> None

(* The place of the whole expression, such as `math.sin`, and the name after the dot. *)
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

(* `zeros(1, 4)` and `range(1, 20)` *)
let new_array (t : Unknown.t) =
  let open Basis.Let_syntax.Option in
  let* whole, arguments = Name_in_text.arguments ~text:(Unknown.text t) t.name.span in
  match (t.name.text, Other_function.range arguments) with
  | ("range" | "arange"), Some (first, last) when follows t "seeds = " ->
      Some (whole, Printf.sprintf "%d `to` %d" first last)
  | _ ->
      let* text = Other_function.new_array t.name.text arguments in
      Some (whole, text)

let of_module (t : Unknown.t) = of_a_module ~text:(Unknown.text t) t.name

(* The kind of container that this library function returns. *)
let container word =
  match word with
  | "keyPressed" | "edge" | "edgeJust" | "falling" | "when" | "after" | "every" | "now" | "never"
  | "tag" | "mapE" | "mergeE" | "mergeR" | "filterEvent" | "pairEvents" | "accum" | "lidar"
  | "snapshot" ->
      Some "Event"
  | "sonars" | "map" | "imap" | "generate" | "zipWith" | "scanl" | "replace" | "sort" ->
      Some "Array"
  | "forward" | "turnBy" | "driveTo" | "ask" | "mkTask" | "timeOut" | "abortWhen" -> Some "Task"
  | _ -> if word <> "" && word.[0] = '[' then Some "Array" else None

(* The kind of container that this argument evaluates to. It is known if the argument begins with a
   library function that returns a container, or if the right-hand side of the equation that defines
   the argument does. *)
let kind_of (t : Unknown.t) argument =
  let first text =
    let text = String.map (fun c -> if c = '(' then ' ' else c) text in
    List.find_opt (( <> ) "") (String.split_on_char ' ' text)
  in
  let right_side name =
    let of_line line =
      match String.index_opt line '=' with
      | Some i when String.equal (String.trim (String.sub line 0 i)) name ->
          Some (String.sub line (i + 1) (String.length line - i - 1))
      | Some _ | None -> None
    in
    List.find_map of_line (String.split_on_char '\n' (Unknown.text t))
  in
  let of_head text = Option.bind (first text) container in
  match of_head argument with
  | Some kind -> Some kind
  | None -> Option.bind (right_side argument) of_head

(* `fmap f e` or `filter f e`, if the kind of container is known from the argument, or is the only
   one in the signature *)
let of_a_container (t : Unknown.t) =
  let words =
    Option.fold
      (Name_in_text.signature ~text:(Unknown.text t) t.name.span)
      ~none:[]
      ~some:(fun line ->
        String.split_on_char ' ' (String.map (fun c -> if Character.is_name c then c else ' ') line))
  in
  let containers = [ ("Array", Phrase.In_array); ("Event", In_event); ("Task", In_task) ] in
  let of_the_argument =
    match application t with
    | Some (_, [ _; argument ]) ->
        Option.bind (kind_of t argument) (fun kind -> List.assoc_opt kind containers)
    | Some _ | None -> None
  in
  match
    (of_the_argument, List.filter (fun (container, _) -> List.mem container words) containers)
  with
  | Some place, _ | None, [ (_, place) ] ->
      Option.bind (Phrasebook.find place t.name.text) (fun row ->
          Option.map (fun text -> (t.name.span, text)) row.replacement)
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

(* Is this argument a number, with or without a unit? *)
let is_a_literal text =
  let text =
    if String.starts_with ~prefix:"(-" text && String.ends_with ~suffix:")" text then
      String.sub text 2 (String.length text - 3)
    else text
  in
  let end_ = Option.value (String.index_opt text '[') ~default:(String.length text) in
  float_of_string_opt (String.sub text 0 end_) <> None

(* The dimensions in `zeros(2, 3)` or `zeros 4`, without dimensions of size 1. *)
let dimensions arguments =
  let all = List.map (fun text -> int_of_string_opt (String.trim text)) arguments in
  if List.mem None all then None else Some (List.filter (( <> ) 1) (List.filter_map Fun.id all))

(* An array of equal numbers: an array literal if it is small, otherwise an application of
   `generate`. *)
let filled_with digit arguments =
  let row x n = "[" ^ String.concat ", " (List.init n (fun _ -> x)) ^ "]" in
  match dimensions arguments with
  | Some [ n ] when n > 0 && n <= 8 -> Some (row digit n)
  | Some [ n; m ] when n > 0 && m > 0 && n * m <= 16 -> Some (row (row digit m) n)
  | Some [ _ ] -> Some (Printf.sprintf "(generate (const %s))" digit)
  | Some [ _; _ ] -> Some (Printf.sprintf "(generate (const (generate (const %s))))" digit)
  | Some _ | None -> None

(* These are not rows of the phrasebook because their results depend on the arguments. *)
let by_arguments name arguments =
  match (name, arguments) with
  | ("zeros" | "ones"), _ :: _ ->
      filled_with (if String.equal name "zeros" then "0" else "1") arguments
  | ("constrain" | "clip" | "saturate" | "clampTo"), [ low; high; x ]
    when is_a_literal low && not (is_a_literal x) ->
      Some (Printf.sprintf "clamp %s %s %s" low high x)
  | ("constrain" | "clip" | "saturate" | "clampTo"), [ x; low; high ] ->
      Some (Printf.sprintf "clamp %s %s %s" low high x)
  | ("deg2rad" | "radians" | "toRadians" | "to_radians"), [ x ] ->
      Some (if float_of_string_opt x = None then x ^ " * 1[deg]" else x ^ "[deg]")
  | ("sleep" | "wait"), [ t ] when String.ends_with ~suffix:"s]" t ->
      Some (Printf.sprintf "sleepT %s restingOutput" t)
  | _ -> None

(* `zeros(4)` or `zeros 4` *)
let call_or_application (t : Unknown.t) =
  match Name_in_text.in_parentheses ~text:(Unknown.text t) t.name.span with
  | Some (whole, inside) when List.mem t.name.text [ "zeros"; "ones" ] ->
      Some (whole, String.split_on_char ',' inside)
  | Some _ | None -> application t

(* `zip xs ys`, rewritten with its arguments in Frob's order *)
let applied_in_text (t : Unknown.t) =
  Option.bind (call_or_application t) (fun (whole, arguments) ->
      match by_arguments t.name.text arguments with
      | Some text -> Some (whole, text)
      | None ->
          Option.map
            (fun (text, _) -> (whole, text))
            (Phrasebook.applied Call t.name.text arguments))

let member (t : Unknown.t) =
  if t.namespace = Values && Phrasebook.find Object t.name.text <> None then field t else None

let import_of (t : Unknown.t) text =
  let of_row =
    Option.bind (application t) (fun (_, arguments) ->
        Option.bind (Phrasebook.applied Call t.name.text arguments) (fun (_, row) -> row.hint))
  in
  match of_row with
  | Some hint -> hint
  | None when String.starts_with ~prefix:"clamp " text -> ", with `import Control`"
  | None when String.starts_with ~prefix:"countWhere " text -> ", with `import Arrays`"
  | None when String.starts_with ~prefix:"delay 0 " text ->
      ", where 0 is the value at the first instant"
  | None when String.starts_with ~prefix:"sleepT " text ->
      ", which keeps the robot at rest for that time"
  | None when String.contains text '`' -> ", which includes both numbers"
  | None when String.starts_with ~prefix:"[" text -> ": an array literal lists its elements"
  | None when String.starts_with ~prefix:"generate " text ->
      ": its type determines the number of elements"
  | None when of_module t <> None -> Printf.sprintf ", without `%s.`" t.name.text
  | None -> ""

let controller (t : Unknown.t) =
  Option.bind (application t) (fun (_, arguments) ->
      Option.map fst (Phrasebook.applied Controller t.name.text arguments))

let call (t : Unknown.t) =
  let in_parentheses (t : Unknown.t) = Name_in_text.call ~text:(Unknown.text t) t.name.span in
  if t.namespace <> Values then None
  else
    List.find_map
      (fun rule -> rule t)
      [
        new_array;
        in_parentheses;
        power_in_text;
        length_in_text;
        rate_in_text;
        of_module;
        counted_in_text;
        of_a_container;
        applied_in_text;
      ]
