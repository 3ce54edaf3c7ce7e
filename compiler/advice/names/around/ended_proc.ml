open Basis
open Syntax.Ir

type hint = { text : string; edits : (Span.t * string) list }

(* {1 The nodes around a name} *)

let contains (outer : Span.t) (inner : Span.t) =
  let compare (a : Span.position) (b : Span.position) =
    match Int.compare (Span.line a) (Span.line b) with
    | 0 -> Int.compare (Span.column a) (Span.column b)
    | order -> order
  in
  compare outer.start inner.start <= 0 && compare inner.stop outer.stop <= 0

(* The expressions that contain the place, innermost first. *)
let around (program : program) at =
  let rec go found (node : Syntax.Node.t) =
    if not (contains (Syntax.Node.span node) at) then found
    else
      let found = match node with Expression e -> e :: found | _ -> found in
      match
        List.find_opt
          (fun child -> contains (Syntax.Node.span child) at)
          (Syntax.Node.children node)
      with
      | Some child -> go found child
      | None -> found
  in
  let is_it (d : declaration) = contains d.span at in
  match List.find_opt is_it program.declarations with
  | Some d -> go [] (Syntax.Node.Declaration d)
  | None -> []

let rec strip (e : expr) = match e.desc with Parenthesized e -> strip e | _ -> e

let spine e =
  let rec go arguments (e : expr) =
    match e.desc with Apply (f, x) -> go (x :: arguments) f | _ -> (e, arguments)
  in
  go [] e

let is_named names (e : expr) =
  match e.desc with
  | Variable { qualifier = None; name; _ } -> List.mem name.text names
  | _ -> false

(* {1 A [proc] without a name for its input} *)

let without_name program (name : name) =
  let input (e : expr) = match e.desc with Proc { input; _ } -> Some input | _ -> None in
  match List.find_map input (around program name.span) with
  | Some { desc = Any; span } ->
      Some
        {
          text = Printf.sprintf "give the input of this `proc` a name: `proc %s -> …`" name.text;
          edits = [ (span, name.text) ];
        }
  | Some _ | None -> None

let is_in_second_where (program : program) (name : name) =
  let is_it (d : declaration) =
    match d.desc with
    | Binding
        {
          right =
            {
              body = Plain { desc = Proc { body = Output { equations = _ :: _; _ }; _ }; _ };
              where = _ :: _ as where;
            };
          _;
        } ->
        List.exists (fun (d : declaration) -> contains d.span name.span) where
    | _ -> false
  in
  List.exists is_it program.declarations

let lambda_before_where (program : program) (name : name) =
  let is_it (p : pattern) =
    match p.desc with Bound x -> String.equal x.text name.text | _ -> false
  in
  let of_declaration (d : declaration) =
    match d.desc with
    | Binding
        {
          left = Name defined;
          right = { body = Plain { desc = Lambda { parameters = [ p ]; _ }; span }; where };
          _;
        }
      when is_it p && List.exists (fun (d : declaration) -> contains d.span name.span) where ->
        Some (defined, { span with stop = p.span.stop })
    | _ -> None
  in
  List.find_map of_declaration program.declarations

(* {1 [switch]} *)

let quote ~text (at : Span.t) =
  let sources = Source.create () in
  Source.add sources ~file:at.file text;
  Source.quote sources at

(* The text of [whole] with [part] replaced. *)
let with_part ~text (whole : Span.t) ~(part : Span.t) replacement =
  Option.map
    (fun written ->
      let column = Span.column whole.start in
      let from = Span.column part.start - column and until = Span.column part.stop - column in
      String.sub written 0 from ^ replacement
      ^ String.sub written until (String.length written - until))
    (quote ~text whole)

let rec count name (node : Syntax.Node.t) =
  let own = match node with Expression e when is_named [ name ] e -> 1 | _ -> 0 in
  List.fold_left (fun n child -> n + count name child) own (Syntax.Node.children node)

(* The whole application of the innermost [switch] that has the name in one of its arguments. *)
let switch_around program (name : name) =
  let is_switch e =
    let head, arguments = spine e in
    if is_named [ "switch"; "dSwitch" ] head then Some (e, head, arguments) else None
  in
  match List.filter_map is_switch (around program name.span) with
  | [] -> None
  | (_, first, _) :: _ as all ->
      let same (_, (head : expr), _) = Span.compare head.span first.span = 0 in
      Some (List.nth all (List.length (List.filter same all) - 1))

(* Returns the application whose last argument is the name, and its place, including any parentheses
   around it. If there is no such application, returns the name itself and its place. *)
let value_of program (name : name) =
  let rec go (value : expr) = function
    | ({ desc = Apply (_, x); _ } as whole : expr) :: outer when x.span = value.span ->
        (whole, parenthesized whole outer)
    | _ -> (value, value.span)
  and parenthesized whole : expr list -> Span.t = function
    | { desc = Parenthesized e; span } :: _ when e == whole -> span
    | _ -> whole.span
  in
  match around program name.span with value :: outer -> Some (go value outer) | [] -> None

let in_next_mode ~text program (name : name) ~event (lambda : expr) (body : expr) =
  let open Let_syntax.Option in
  let* value, place = value_of program name in
  let* event = Option.bind event (fun (e : expr) -> quote ~text e.span) in
  let* value = quote ~text value.span in
  if count name.text (Syntax.Node.Expression lambda) <> 1 then None
  else
    let* next = with_part ~text body.span ~part:place "x" in
    Some
      {
        text =
          Printf.sprintf
            "carry the value in the event: write `tag %s %s` in place of `%s`, and `\\x -> %s` here"
            (Source.grouped event) (Source.grouped value) event next;
        edits = [];
      }

let as_separate_event ~text (head : expr) (input : pattern) (output : expr) (event : expr) rest =
  let open Let_syntax.Option in
  let* x = quote ~text input.span in
  let quote (e : expr) = quote ~text e.span in
  let* switch = quote head in
  let* output = quote output in
  let* event = quote (strip event) in
  let rest = List.map quote rest in
  let rest = if List.mem None rest then [ "…" ] else List.filter_map Fun.id rest in
  let pair = Printf.sprintf "(proc %s -> (%s, %s))" x output event in
  Some
    {
      text =
        Printf.sprintf
          "`%s` takes the output and the event as a pair in its first argument: write `%s`" switch
          (String.concat " " (switch :: pair :: rest));
      edits = [];
    }

let of_switch ~text program (name : name) =
  match switch_around program name with
  | Some (_, head, first :: second :: rest) when contains second.span name.span -> (
      match ((strip first).desc, (strip second).desc) with
      | Proc { body = Output { output; _ }; _ }, Lambda { parameters = [ { desc = Any; _ } ]; body }
        ->
          let event =
            match (strip output).desc with Tuple [ _; event ] -> Some event | _ -> None
          in
          in_next_mode ~text program name ~event (strip second) body
      | _, Lambda _ -> None
      | Proc { input; body = Output { output; equations = [] } }, _ ->
          as_separate_event ~text head input output second rest
      | _ -> None)
  | _ -> None
