open Basis
open Flow

let by_a_switch (passage : Fact.passage) = Option.is_some passage.through.machine

let through = function
  | [] -> ""
  | via ->
      let name passage =
        (* The node of a switch has the name of the definition that contains the switch. *)
        if by_a_switch passage then "a switch" else Printf.sprintf "`%s`" passage.through.origin
      in
      ", through " ^ String.concat " and " (List.map name via)

(* The outputs that depend on an input in the same instant and are in a different file from the hop.
   If the library closes the loop around one of the program's signal functions, as [loop] does, such
   an output is the only place that the user can change. *)
let elsewhere (hop : Fact.hop) =
  List.filter_map
    (fun (passage : Fact.passage) ->
      match passage.output with
      | Signal output when passage.input <> "" && output.span.file <> hop.at.file ->
          Some (passage, output.span)
      | Signal _ | Bool _ | Int _ | Float _ -> None)
    hop.via

let label_elsewhere hop d =
  let label d ((passage : Fact.passage), at) =
    let text =
      Printf.sprintf "`%s` passes `%s` to this output in the same instant" passage.through.origin
        passage.input
    in
    Diagnostic.label ~at "%s" text d
  in
  List.fold_left label d (elsewhere hop)

let reads (hop : Fact.hop) = Printf.sprintf "reads `%s` here%s" hop.read.name (through hop.via)

(* Whether the name can be used as an expression, unlike the name of a component ([p.1]). *)
let is_expression name =
  List.for_all
    (fun part -> part <> "" && not (part.[0] >= '0' && part.[0] <= '9'))
    (String.split_on_char '.' name)

let hint_elsewhere (passage : Fact.passage) =
  Printf.sprintf "let `%s` read the previous value of `%s`, with `delay`" passage.through.origin
    passage.input

(* The hint for a loop that is closed in the library. The signals of such a loop have no names. *)
let hint_within = "put a `delay` or an `integral` into the signal function inside the loop"

(* A likely initial value of the signal, chosen by its type. *)
let initial sums (signal : Ir.signal) =
  match signal.ty with
  | Bool -> "False"
  | Int | Float -> "0"
  | Sum i -> (
      match (sums.(i) : Ir.sum).constructors with
      | { constructor; fields = [] } :: _ -> constructor
      | _ -> "x0")
  | Array _ | Foreign _ -> "x0"

(* The hint for a loop that is closed by an equation on one line. It suggests the same equation with
   the previous value, or an integral. *)
let of_equation sources sums (first : Fact.hop) (last : Fact.hop) =
  let read = last.read in
  let start = initial sums read in
  if String.equal start "x0" || last.via <> [] || not (is_expression read.name) then None
  else
    let shown (own : Own_equation.t) =
      String.concat " and "
        (List.map
           (fun (name, right) -> Printf.sprintf "`%s = %s`" name right)
           (Option.to_list own.before @ [ (last.reader.name, own.right) ]))
    in
    let hint (own : Own_equation.t) =
      match own.kind with
      | Integral -> Printf.sprintf "for the sum over time, write %s" (shown own)
      | Previous ->
          Printf.sprintf "let `%s` read %s: write %s, where %s is the initial value"
            last.reader.name
            (if last.reader.id = read.id then "its own previous value"
             else Printf.sprintf "the previous value of `%s`" first.reader.name)
            (shown own) start
    in
    Own_equation.fix sources ~name:last.reader.name ~at:last.reader.span ~read:read.name ~start
    |> Option.map (fun (own : Own_equation.t) d ->
           Diagnostic.hint "%s" (hint own) d
           |> Diagnostic.fix (Printf.sprintf "write %s" (shown own)) own.edits)

let hint_here sums (first : Fact.hop) (last : Fact.hop) =
  let read = last.read in
  let whose =
    if last.reader.id = read.id then Printf.sprintf "let `%s` read its own previous value" read.name
    else
      Printf.sprintf "let `%s` read the previous value of `%s`" last.reader.name first.reader.name
  in
  if is_expression read.name then
    let start = initial sums read in
    let name = if List.mem "before" [ last.reader.name; read.name ] then "earlier" else "before" in
    Printf.sprintf
      "%s: add the equation `%s = delay %s %s`, where %s is the initial value, and read `%s` here"
      whose name start read.name
      (if start = "x0" then "`x0`" else start)
      name
  else whose ^ ", with `delay`"

(* Maximum number of hops in a message. If the loop is longer, the message omits hops just before
   the last one. *)
let longest_shown = 12

let shorten hops =
  let n = List.length hops in
  if n <= longest_shown then (hops, 0)
  else (List.filteri (fun i _ -> i < longest_shown - 1 || i = n - 1) hops, n - longest_shown)

let named sources ({ hops; sums; entry; _ } : Fact.loop) =
  let first = List.hd hops in
  let last = List.nth hops (List.length hops - 1) in
  let at = first.reader.span in
  let label d (hop : Fact.hop) =
    (if Span.compare hop.at at = 0 && d.Diagnostic.here = None then
       Diagnostic.here "%s" (reads hop) d
     else Diagnostic.label ~at:hop.at "`%s` %s" hop.reader.name (reads hop) d)
    |> label_elsewhere hop
  in
  let d =
    Diagnostic.error ~code:"E0401" ~at "the signal `%s` needs its own value in the same instant"
      first.reader.name
  in
  let shown, left_out = shorten hops in
  let complete =
    let own (_, (at : Span.t)) = Own_code.is_own ~entry at in
    match (List.concat_map elsewhere hops, Own_code.is_own ~entry last.at) with
    | (_ :: _ as others), false -> Diagnostic.hint "%s" (hint_elsewhere (fst (List.hd others)))
    | others, true when List.exists own others ->
        Diagnostic.hint "%s" (hint_elsewhere (fst (List.find own others)))
    | _, true ->
        Option.value
          (of_equation sources sums first last)
          ~default:(Diagnostic.hint "%s" (hint_here sums first last))
    | [], false -> Diagnostic.hint "%s" hint_within
  in
  let d = List.fold_left label d shown |> complete in
  let d =
    if List.exists (fun (hop : Fact.hop) -> List.exists by_a_switch hop.via) hops then
      Diagnostic.note
        "each output of a switch depends on every input that the signal functions inside the \
         switch read in the same instant"
        d
    else d
  in
  if left_out = 0 then d
  else
    Diagnostic.note "the loop goes through %d more signals before `%s`" left_out last.reader.name d

let rotate_to first hops =
  let rec go before = function
    | hop :: after when hop != first -> go (hop :: before) after
    | after -> List.rev_append (List.rev after) (List.rev before)
  in
  go [] hops

(* Shows the loop, starting with the place that comes first in the source. *)
let unnamed hops =
  let earlier (a : Fact.hop) (b : Fact.hop) = if Span.compare b.at a.at < 0 then b else a in
  let first = List.fold_left earlier (List.hd hops) hops in
  let d =
    Diagnostic.error ~code:"E0401" ~at:first.at "a signal needs its own value in the same instant"
  in
  let label d (hop : Fact.hop) =
    if Span.compare hop.at first.at = 0 then d
    else Diagnostic.label ~at:hop.at "the loop continues here%s" (through hop.via) d
  in
  List.fold_left label d (fst (shorten (rotate_to first hops)))
  |> Diagnostic.here "the value comes back here%s" (through first.via)
  |> Diagnostic.hint "read the previous value instead, with `delay`"

let diagnostic sources (loop : Fact.loop) =
  let d = if loop.named then named sources loop else unnamed loop.hops in
  match loop.run_by with
  | None -> d
  | Some (name, at) -> Diagnostic.label ~at "`%s` runs here" name d
