open Basis
open Resolve

type advice = Report of Diagnostic.t | Reported

let line_of (t : Unknown.t) (span : Span.t) = Name_in_text.line_of (Unknown.text t) span
let index (t : Unknown.t) = Span.column t.name.span.start - 1

let is_a_type (t : Unknown.t) =
  t.namespace = Constructors && Visible.is_known t.module_.visible Interface.tycons t.name.text

let error (t : Unknown.t) what =
  Diagnostic.error ~code:(Namespace.unknown t.namespace) ~at:t.name.span "%s a type" what

(* `Velocity v = 0.3[m/s]`, in which the type is parsed as the constructor of a pattern. Only the
   first word of the type is reported. *)
let equation (t : Unknown.t) =
  match Typed_equation.of_line (line_of t t.name.span) with
  | Some typed when is_a_type t && index t = typed.start ->
      let column n = Span.position ~line:(Span.line t.name.span.start) ~column:(n + 1) in
      let first = if typed.in_a_let then typed.start else typed.first in
      let place = { t.name.span with start = column first; stop = column typed.stop } in
      let what = if String.equal typed.sign "=" then "an equation" else "a statement" in
      Some
        (Report
           (error t (what ^ " cannot start with")
           |> Diagnostic.hint "%s" (Typed_equation.advice typed)
           |> Diagnostic.fix "remove the type" [ (place, "") ]))
  | Some typed when is_a_type t && index t < typed.stop -> Some Reported
  | Some _ | None -> None

(* `f (Float x) = …`. Only the first type is reported. *)
let parameter (t : Unknown.t) =
  let line = line_of t t.name.span in
  match Typed_equation.of_parameters line with
  | Some hint when is_a_type t && index t < String.index line '=' ->
      if Name_in_text.before ~text:(Unknown.text t) t.name.span = '(' then
        Some (Report (error t "a parameter cannot have" |> Diagnostic.hint "%s" hint))
      else Some Reported
  | Some _ | None -> None

(* `half Float x = x / 2`. Only the first type is reported. *)
let words (t : Unknown.t) =
  let line = line_of t t.name.span in
  match Typed_equation.of_words line with
  | Some hint when is_a_type t && index t < String.index line '=' ->
      let first =
        let rec go i = if Character.is_upper line.[i] then i else go (i + 1) in
        go 0
      in
      if index t = first then
        Some (Report (error t "a parameter cannot have" |> Diagnostic.hint "%s" hint))
      else Some Reported
  | Some _ | None -> None

(* `\\Float x -> x / 2`. Only the first type is reported. *)
let lambda (t : Unknown.t) =
  let line = line_of t t.name.span in
  let at = index t in
  match String.rindex_from_opt line (min at (String.length line - 1)) '\\' with
  | Some first when is_a_type t -> (
      let rest = String.sub line (first + 1) (String.length line - first - 1) in
      match Text_place.find "->" rest with
      | Some arrow when first + 1 + arrow > at -> (
          let inside = String.sub rest 0 arrow in
          let blank = function '(' | ')' | ',' -> ' ' | c -> c in
          let words = String.split_on_char ' ' (String.map blank inside) in
          match Typed_equation.pairs (List.filter (( <> ) "") words) with
          | Some (_ :: _ as all) when String.trim (String.sub rest 0 (at - first - 1)) = "" ->
              Some
                (Report
                   (error t "a parameter cannot have"
                   |> Diagnostic.hint "write `\\%s ->`, without types"
                        (String.concat " " (List.map snd all))))
          | Some (_ :: _) -> Some Reported
          | Some [] | None -> None)
      | Some _ | None -> None)
  | Some _ | None -> None

let of_declaration t of_line (d : Proc_signals.c_declaration) =
  match of_line (line_of t d.head.span) with
  | Some (typed : Typed_equation.t) when String.equal typed.name d.declared.text -> Some typed
  | Some _ | None -> None

(* The name `v` in `const Velocity v = 0.3[m/s]`, which is parsed as the definition of a function
   `const`. *)
let declared (t : Unknown.t) =
  match Unknown.c_declaration t with
  | Some d when t.namespace = Values && of_declaration t Typed_equation.of_line d <> None ->
      Some Reported
  | Some _ | None -> None

let rules = [ equation; parameter; words; lambda; declared ]
