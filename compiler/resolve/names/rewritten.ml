open Basis
open Interface
open Scope

let unit_after_number t space (name : Syntax.Ir.name) =
  if String.equal space.noun "name" && is_known t units name.text then
    Name_in_text.unit_after_number ~text:t.text ~is_unit:(is_known t units) name.span
  else None

(* `pow v 2`, with the arguments of Frob and the name of another language. *)
let power_in_text t (name : Syntax.Ir.name) =
  match (name.text, Name_in_text.application ~text:t.text name.span) with
  | ("pow" | "powf"), Some (whole, [ base; exponent ]) ->
      Syntax.Other_notation.expression (Printf.sprintf "pow(%s, %s)" base exponent)
      |> Option.map (fun text -> (whole, text))
  | _ -> None

let integral t (name : Syntax.Ir.name) =
  if not (List.mem name.text [ "dt"; "deltaTime"; "delta_t" ]) then None
  else
    Option.bind (Name_in_text.assigned ~text:t.text name.span) (fun (x, right, place) ->
        Option.map (fun integral -> (x, integral, place)) (Own_equation.integral ~name:x right))

(* `(x - xBefore) / dt` *)
let rate_in_text t (name : Syntax.Ir.name) =
  if not (List.mem name.text [ "dt"; "deltaTime"; "delta_t" ]) then None
  else
    Option.map
      (fun (whole, x) -> (whole, "derivative " ^ x))
      (Name_in_text.divided_difference ~text:t.text name.span)

(* `len a`, as a factor or divisor of Floats *)
let length_in_text t (name : Syntax.Ir.name) =
  match (name.text, Name_in_text.application ~text:t.text name.span) with
  | ("len" | "sizeof"), Some (whole, [ argument ]) ->
      let text = "length " ^ argument in
      let is_factor =
        List.exists
          (fun operator -> Name_in_text.follows ~text:t.text operator name.span)
          [ "/ "; "* " ]
      in
      Some (whole, if is_factor then Printf.sprintf "toFloat (%s)" text else text)
  | _ -> None

(* `math.sin(x)`, which is parsed as a field of `math` *)
let of_a_module t (name : Syntax.Ir.name) =
  if not (List.mem name.text [ "math"; "np"; "numpy"; "Math" ]) then None
  else
    Option.bind (Name_in_text.field ~text:t.text name.span) (fun whole ->
        let n = Span.column whole.stop - Span.column name.span.stop - 1 in
        let line = List.nth (String.split_on_char '\n' t.text) (Span.line whole.start - 1) in
        let field = String.sub line (Span.column name.span.stop) n in
        match Other_languages.constant field with
        | Some text -> Some (whole, text)
        | None -> Name_in_text.call ~text:t.text whole)

(* `fmap f e` or `filter f e`, where the signature contains only one kind of container, and
   `length (filter f xs)` *)
let of_a_container t (name : Syntax.Ir.name) =
  let words =
    Option.fold (Name_in_text.signature ~text:t.text name.span) ~none:[] ~some:(fun line ->
        String.split_on_char ' ' (String.map (fun c -> if Character.is_name c then c else ' ') line))
  in
  let kinds = List.filter (fun kind -> List.mem kind words) [ "Array"; "Event"; "Task" ] in
  match (Other_languages.of_each name.text, kinds) with
  | Some choices, [ kind ] ->
      Option.map (fun text -> (name.span, text)) (List.assoc_opt kind choices)
  | _ -> None

let counted_in_text t (name : Syntax.Ir.name) =
  match Name_in_text.application ~text:t.text name.span with
  | Some (whole, ([ _; _ ] as arguments))
    when String.equal name.text "filter" && Name_in_text.follows ~text:t.text "length (" name.span
    ->
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
let applied_in_text t (name : Syntax.Ir.name) =
  Option.bind (Name_in_text.application ~text:t.text name.span) (fun (whole, arguments) ->
      Option.map (fun (text, _) -> (whole, text)) (Other_languages.applied name.text arguments))

let member t (name : Syntax.Ir.name) =
  if not (Other_languages.is_an_object name.text) then None
  else
    Option.map
      (fun (whole : Span.t) ->
        let n = Span.column whole.stop - Span.column name.span.stop - 1 in
        let line = List.nth (String.split_on_char '\n' t.text) (Span.line whole.start - 1) in
        (whole, String.sub line (Span.column name.span.stop) n))
      (Name_in_text.field ~text:t.text name.span)

let import_of t (name : Syntax.Ir.name) text =
  let module_ =
    match Name_in_text.application ~text:t.text name.span with
    | Some (_, arguments) -> Option.bind (Other_languages.applied name.text arguments) snd
    | None -> None
  in
  match module_ with
  | Some module_ -> Printf.sprintf ", with `import %s`" module_
  | None when String.starts_with ~prefix:"clamp " text -> ", with `import Control`"
  | None when String.starts_with ~prefix:"countWhere " text -> ", with `import Arrays`"
  | None when String.starts_with ~prefix:"delay 0 " text ->
      ", where 0 is the value at the first instant"
  | None when String.starts_with ~prefix:"sleepT " text -> ": the robot rests meanwhile"
  | None -> ""

let controller t (name : Syntax.Ir.name) =
  match Name_in_text.application ~text:t.text name.span with
  | Some (whole, [ kp; ki; kd; e ]) when Other_languages.is_of_gains name.text ->
      Some
        (whole, Printf.sprintf "pid (Pid { kp = %s, ki = %s, kd = %s, largest = … }) %s" kp ki kd e)
  | Some _ | None -> None

let call t space (name : Syntax.Ir.name) =
  if not (String.equal space.noun "name") then None
  else
    match Name_in_text.call ~text:t.text name.span with
    | Some call -> Some call
    | None ->
        List.find_map
          (fun rule -> rule t name)
          [
            power_in_text;
            length_in_text;
            rate_in_text;
            of_a_module;
            counted_in_text;
            of_a_container;
            applied_in_text;
          ]
