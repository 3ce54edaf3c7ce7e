type file = { text : string; starts : int array Lazy.t  (** where each line starts *) }
type t = (string, file) Hashtbl.t

let create () : t = Hashtbl.create 16

let line_starts text =
  let starts = ref [ 0 ] in
  String.iteri (fun i c -> if c = '\n' then starts := (i + 1) :: !starts) text;
  Array.of_list (List.rev !starts)

let add t ~file text = Hashtbl.replace t file { text; starts = lazy (line_starts text) }
let text t file = Option.map (fun f -> f.text) (Hashtbl.find_opt t file)

let line t file n =
  match Hashtbl.find_opt t file with
  | None -> None
  | Some { text; starts = (lazy starts) } ->
      if n < 1 || n > Array.length starts then None
      else
        let start = starts.(n - 1) in
        let stop = if n < Array.length starts then starts.(n) - 1 else String.length text in
        let stop = if stop > start && text.[stop - 1] = '\r' then stop - 1 else stop in
        Some (String.sub text start (stop - start))

let offset t file (p : Span.position) =
  match Hashtbl.find_opt t file with
  | None -> 0
  | Some { text; starts = (lazy starts) } ->
      let length = String.length text in
      if Span.line p < 1 then 0
      else if Span.line p > Array.length starts then length
      else min length (starts.(Span.line p - 1) + Span.column p - 1)

let quote t (span : Span.t) =
  match line t span.file (Span.line span.start) with
  | Some text when Span.line span.start = Span.line span.stop ->
    let first = Span.column span.start - 1 and after = Span.column span.stop - 1 in
    if 0 <= first && first <= after && after <= String.length text then
      Some (String.sub text first (after - first))
    else None
  | _ -> None

let grouped text =
  let joins c = String.contains "() +-*/<>=&|$." c in
  let open_bracket = String.index_opt text '[' in
  let outside = match open_bracket with
    | Some i when String.ends_with ~suffix:"]" text && i > 0 -> String.sub text 0 i
    | _ -> text
  in
  let is_number = text <> "" && String.for_all (fun c -> ('0' <= c && c <= '9') || c = '.') outside in
  if text = "()" || is_number || not (String.exists joins text) then text else "(" ^ text ^ ")"
