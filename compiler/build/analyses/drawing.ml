open Basis
open Basis.Let_syntax.Option

let probe = "draw"
let if_any = "the drawing, if there is one"
let is_shown r = List.exists (fun p -> List.mem p [ probe; if_any; "all" ]) (Request.probes r)

let row (program : Flow.Ir.program) =
  match program.marks with
  | 0 -> ""
  | n -> Printf.sprintf "%s :: drawings, at most %d marks at a time\n" probe n

let others (program : Flow.Ir.program) names =
  let names = List.filter (fun name -> name <> if_any) names in
  if program.marks = 0 then names else List.filter (fun name -> name <> probe) names

let without_bound sink (written : Typing.Ir.definition) =
  Diagnostic.error ~code:"E0432" ~at:(Probes.name_of written)
    "`%s` may draw more than %d marks in an instant" written.name.name Flow.Marks.limit
  |> Diagnostic.note "the maximum number of marks must be known before the program runs"
  |> Diagnostic.hint
       "draw on a new output in each instant: an output that is stored, for example by `delay`, \
        keeps its marks"
  |> Diagnostic.emit sink;
  None

(* A constructor's tag is stored in one byte. *)
let most_labels = 256

let check_labels sink (written : Typing.Ir.definition) (program : Flow.Ir.program) =
  let too_many (sum : Flow.Ir.sum) =
    String.equal sum.module_ "Display"
    && String.equal sum.name "Text"
    && List.compare_length_with sum.constructors most_labels > 0
  in
  if Array.exists too_many program.sums then (
    Diagnostic.error ~code:"E0413" ~at:(Probes.name_of written)
      "`%s` draws more than %d different strings" written.name.name most_labels
    |> Diagnostic.emit sink;
    None)
  else Some ()

let bound sink written (counted : Flow.Ir.program) =
  let* () = check_labels sink written counted in
  match Flow.Marks.most counted with None -> without_bound sink written | Some most -> Some most
