type file = { text : string; starts : int array Lazy.t  (** offset of each line's start *) }
type t = (string, file) Hashtbl.t

let create () : t = Hashtbl.create 16

let line_starts text =
  let starts = ref [ 0 ] in
  String.iteri (fun i c -> if c = '\n' then starts := (i + 1) :: !starts) text;
  Array.of_list (List.rev !starts)

let add t ~file text = Hashtbl.replace t file { text; starts = lazy (line_starts text) }

let all t =
  List.sort compare (Hashtbl.fold (fun file { text; _ } others -> (file, text) :: others) t [])

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

(* Does the last character close the bracket at the start? *)
let in_brackets text =
  let last = String.length text - 1 in
  let rec closes depth i =
    match text.[i] with
    | '(' | '[' | '{' -> closes (depth + 1) (i + 1)
    | ')' | ']' | '}' -> if depth = 1 then i = last else closes (depth - 1) (i + 1)
    | _ -> i < last && closes depth (i + 1)
  in
  last > 0 && (text.[0] = '(' || text.[0] = '[') && closes 0 0

(* A number with an optional unit, which may contain operators. *)
let is_number text =
  let n = match String.index_opt text '[' with Some i -> i | None -> String.length text in
  n > 0
  && String.for_all (fun c -> Character.is_digit c || c = '.') (String.sub text 0 n)
  && (n = String.length text || text.[String.length text - 1] = ']')

let with_opening text =
  let count c = List.length (String.split_on_char c text) in
  if count ')' > count '(' then "(" ^ text else text

let grouped text =
  let joins c = String.contains " +-*/<>=&|$.^!" c in
  if is_number text || in_brackets text || not (String.exists joins text) then text
  else "(" ^ text ^ ")"
