open Basis

type t = { word : Span.t; equation : string option }

let word = "= return"
let longest = 90

(* Does a signature in the text declare this name as a task? *)
let is_a_task text name =
  let declares line =
    String.starts_with ~prefix:(name ^ " ::") (String.trim line) && Other_type.mentions "Task" line
  in
  List.exists declares (String.split_on_char '\n' text)

let balanced text =
  let count c = List.length (String.split_on_char c text) in
  count '(' = count ')'

(* The text without the parentheses that enclose it, if any. *)
let without_parentheses text =
  let n = String.length text in
  let inside = String.sub text 1 (max 0 (n - 2)) in
  if
    n > 2
    && text.[0] = '('
    && text.[n - 1] = ')'
    && String.equal (Text_place.without_closing inside) inside
  then inside
  else text

let on_line words (at : Span.t) =
  let open Let_syntax.Option in
  let sources = Wording.sources words in
  let number = Span.line at.start in
  let* line = Source.line sources at.file number in
  let* text = Source.text sources at.file in
  let* sign = Text_place.find (word ^ " ") line in
  let left = String.trim (String.sub line 0 sign) in
  let name = List.hd (String.split_on_char ' ' left) in
  if (not (Text_place.is_a_name name)) || is_a_task text name || not (balanced left) then None
  else
    let first = sign + String.length "= " in
    let behind = first + String.length "return " in
    let place column = Span.position ~line:number ~column:(column + 1) in
    let value = Text_place.without_closing (String.sub line behind (String.length line - behind)) in
    let value = without_parentheses value in
    let equation = Printf.sprintf "%s = %s" left value in
    Some
      {
        word = { at with start = place first; stop = place (behind - 1) };
        equation =
          (if value <> "" && String.length equation <= longest then Some equation else None);
      }

let message = "`return` is only for tasks"

let diagnostic words ~(at : Span.t) =
  Option.map
    (fun { word; equation; _ } ->
      Diagnostic.error ~code:"E0301" ~at:word "%s" message
      |> Diagnostic.hint "%s"
           (match equation with
           | Some equation -> Printf.sprintf "write `%s`" equation
           | None -> "write the value after the `=`, without `return`")
      |> Diagnostic.fix "remove `return`" [ ({ word with stop = Span.forward 1 word.stop }, "") ])
    (on_line words at)

let is_returned (e : Resolve.Ir.expr) =
  match e.desc with
  | Apply { head = { desc = Global { name = "return"; module_ = "Prelude" }; _ }; _ } -> true
  | _ -> false
