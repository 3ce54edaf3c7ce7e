open Basis

let signal_of (t : Unknown.t) signals =
  let is_it (signal : Proc_signals.t) = String.equal signal.name.text t.name.text in
  List.find_opt is_it (Lazy.force signals)

let signal (t : Unknown.t) = signal_of t t.signals

(* {1 A [proc] that ends before the name} *)

let ended (t : Unknown.t) =
  let syntax = t.module_.visible.syntax in
  let may_be_input =
    t.namespace = Values
    && (List.mem t.name.text [ "i"; "input"; "sensors" ] || Option.is_some (signal t))
  in
  if not may_be_input then None
  else
    match Ended_proc.without_name syntax t.name with
    | Some hint -> Some hint
    | None -> Ended_proc.of_switch ~text:(Unknown.text t) syntax t.name

let with_hint ({ text; edits } : Ended_proc.hint) diagnostic =
  Diagnostic.hint "%s" text diagnostic |> if edits = [] then Fun.id else Diagnostic.fix text edits

let of_an_input t = Option.map (fun hint -> with_hint hint (Other_meaning.diagnostic t)) (ended t)

(* Whether the name is used in an equation in the `where` of the enclosing definition. *)
let is_in_a_where (t : Unknown.t) =
  let text = Unknown.text t in
  match (Name_in_text.assigned ~text t.name.span, Name_in_text.definition ~text t.name.span) with
  | Some (x, _, _), Some (whole, has_where) -> has_where && not (String.equal x whole)
  | _ -> false

let hint_of_this (t : Unknown.t) (signal : Proc_signals.t) =
  if signal.of_do then
    "a `where` after `do` belongs to the whole definition and cannot use signals: write a `let` in \
     the `do`"
  else if Ended_proc.is_in_second_where t.module_.visible.syntax t.name then
    "this second `where` belongs to the whole definition, so it cannot use signals: move its \
     equations into the first `where`"
  else if is_in_a_where t then
    "the bracket before this `where` ends the `proc`, so the equations after `where` cannot use \
     the signals of the `proc`: move that bracket to the end of the last equation"
  else
    "the `proc` ends at the bracket or comma that follows it: use its signals only before that \
     point, not in a later `where`"

let of_this (t : Unknown.t) =
  Option.map
    (fun (signal : Proc_signals.t) ->
      Other_meaning.diagnostic t
      |> Diagnostic.label ~at:signal.name.span "this `%s` is a signal of the `proc`"
           signal.name.text
      |>
      match if signal.of_do then None else ended t with
      | Some hint -> with_hint hint
      | None -> Diagnostic.hint "%s" (hint_of_this t signal))
    (signal t)

(* {1 A [proc] in another definition} *)

let hint_of_another (t : Unknown.t) (signal : Proc_signals.t) =
  let text = Unknown.text t in
  match
    (Name_in_text.equation ~text signal.name.span, Name_in_text.definition ~text t.name.span)
  with
  | Some equation, Some (definition, has_where) ->
      Printf.sprintf
        "a signal can only be used inside its `proc`: %s, or make the value part of this `proc`'s \
         input"
        (if has_where then Printf.sprintf "add `%s` to the `where` of `%s`" equation definition
         else
           Printf.sprintf "add a `where` to the `proc` in `%s`, and write `%s` below it" definition
             equation)
  | _ ->
      Printf.sprintf
        "a signal can only be used inside its `proc`: move the equation to the `where` of that \
         `proc`, or write a signal function with its own input: `proc %s -> …`"
        t.name.text

let of_another (t : Unknown.t) =
  if t.namespace <> Values then None
  else
    Option.map
      (fun (signal : Proc_signals.t) ->
        Other_meaning.diagnostic t
        |> Diagnostic.label ~at:signal.name.span "this `%s` is a signal of a `proc`" t.name.text
        |> Diagnostic.hint "%s" (hint_of_another t signal))
      (signal_of t t.module_.signals)

(* {1 An anonymous function in place of a [proc]} *)

(* `f = \i -> v where` with `i` in an equation below *)
let of_lambda (t : Unknown.t) =
  if t.namespace <> Values then None
  else
    Option.map
      (fun ((defined : Syntax.Ir.name), at) ->
        let x = t.name.text in
        let signature = Name_in_text.signature ~text:(Unknown.text t) t.name.span in
        let prefix = defined.text ^ " :: SF " in
        let is_signal_function =
          Option.fold signature ~none:(String.equal x "i") ~some:(String.starts_with ~prefix)
        in
        Other_meaning.diagnostic t
        |> Diagnostic.label ~at
             "this function ends before the `where`, so the `where` cannot use its parameter"
        |>
        if is_signal_function then fun d ->
          Diagnostic.hint "for a signal function, write `proc %s -> …`" x d
          |> Diagnostic.write at (Printf.sprintf "proc %s" x)
        else
          Diagnostic.hint "write the parameter on the left side of the equation: `%s %s = …`"
            defined.text x)
      (Ended_proc.lambda_before_where t.module_.visible.syntax t.name)
