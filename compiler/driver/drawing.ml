open Basis

let ( let* ) = Option.bind
let probe = "draw"
let is_seen (r : Request.t) = List.exists (fun p -> List.mem p [ probe; "all" ]) r.probes

let row (program : Flow.Ir.program) =
  match program.marks with
  | 0 -> ""
  | n -> Printf.sprintf "%s :: what is drawn, at most %d at a time\n" probe n

let others (program : Flow.Ir.program) names =
  if program.marks = 0 then names else List.filter (fun name -> name <> probe) names

let without_bound sink (written : Typing.Ir.definition) =
  Diagnostic.error ~code:"E0432" ~at:(Probes.name_of written)
    "`%s` may draw more than %d marks in an instant" written.name.name Flow.Marks.limit
  |> Diagnostic.note "how many there can be is known before a program runs"
  |> Diagnostic.hint
       "an output that is kept, as by `delay`, has its marks with it: draw on a new one"
  |> Diagnostic.emit sink;
  None

(* A constructor is a byte. *)
let most_labels = 256

let check_labels sink (written : Typing.Ir.definition) (program : Flow.Ir.program) =
  let too_many (sum : Flow.Ir.sum) =
    String.equal sum.module_ "Display"
    && String.equal sum.name "Text"
    && List.compare_length_with sum.constructors most_labels > 0
  in
  if Array.exists too_many program.sums then (
    Diagnostic.error ~code:"E0413" ~at:(Probes.name_of written)
      "`%s` draws more than %d different texts" written.name.name most_labels
    |> Diagnostic.emit sink;
    None)
  else Some ()

let program r sink ~written ~specialized (plain : Flow.Ir.program) =
  if plain.marks = 0 then Some plain
  else
    let* counted = specialized (Some 1) in
    let* () = check_labels sink written counted in
    match Flow.Marks.most counted with
    | None -> without_bound sink written
    | Some most when not (is_seen r) -> Some { plain with marks = most }
    | Some 0 -> Some plain
    | Some 1 -> Some counted
    | Some most -> specialized (Some most)
