open Basis
open Syntax.Ir

type t = { name : string; edits : ((int * int) * string) list }

(* {1 Texts} *)

let applied text edits =
  let latest_first ((a, _), _) ((b, _), _) = compare b a in
  List.fold_left
    (fun text ((start, stop), piece) ->
      String.sub text 0 start ^ piece ^ String.sub text stop (String.length text - stop))
    text (List.sort latest_first edits)

let rec end_of_line text i =
  if i < String.length text && text.[i] <> '\n' then end_of_line text (i + 1) else i

let rec start_of_line text i =
  if i > 0 && text.[i - 1] <> '\n' then start_of_line text (i - 1) else i

let between text start stop = String.trim (String.sub text start (stop - start))

(* Removes up to [column] spaces at the start of each line of a text. *)
let at_the_edge ~column piece =
  let rec blanks line i =
    if i < column && i < String.length line && line.[i] = ' ' then blanks line (i + 1) else i
  in
  let moved line =
    let i = blanks line 0 in
    String.sub line i (String.length line - i)
  in
  match String.split_on_char '\n' piece with
  | [] -> ""
  | first :: rest -> String.concat "\n" (first :: List.map moved rest)

let format text =
  match Formatting.Formatter.text (Facts.ignored ()) ~file:"" text with
  | Formatted text -> Some text
  | Broken | Refused _ -> None

let formatted piece = Option.fold (format (piece ^ "\n")) ~none:piece ~some:String.trim

(* The edit of whole lines that turns [before] into [after]. *)
let difference before after =
  let n = String.length before and m = String.length after in
  let rec same_start i = if i < min n m && before.[i] = after.[i] then same_start (i + 1) else i in
  let start = start_of_line before (same_start 0) in
  let rec same_end k =
    if k < min n m - start && before.[n - k - 1] = after.[m - k - 1] then same_end (k + 1) else k
  in
  let k = n - end_of_line before (n - same_end 0) in
  ((start, n - k), String.sub after start (m - start - k))

(* Formats the result if the original text was formatted, because the added arguments may make lines
   too long, and removing a line may change the alignment of its neighbours. *)
let tidy text edits =
  let after = applied text edits in
  match (format text, format after) with
  | Some before, Some tidy when String.equal before text && not (String.equal tidy after) ->
      [ difference text tidy ]
  | _ -> edits

(* {1 Moving a declaration out of its block} *)

type piece = {
  from : int;  (** start of the text that moves to the top level, including the comments above *)
  last : int;  (** its end *)
  cut : int * int;  (** the range to remove from the block *)
}

(* The start of the comment lines that are directly above this line and have the same
   indentation. *)
let rec with_comments text ~column line =
  let above = if line > 0 then start_of_line text (line - 1) else line in
  let comment = String.make column ' ' ^ "--" in
  if above < line && String.starts_with ~prefix:comment (String.sub text above (line - above)) then
    with_comments text ~column above
  else line

(* The piece for a declaration. If it is the only declaration in a `where`, the `where` is removed
   with it. Otherwise, no other code may precede it on its line. *)
let piece text ~alone (start, stop) =
  let line = start_of_line text start and behind = end_of_line text stop in
  let column = start - line in
  let before = between text line start and after = between text stop behind in
  let has_lines = after = "" || String.starts_with ~prefix:"--" after in
  let rec back i = if i > 0 && String.contains " \n\r" text.[i - 1] then back (i - 1) else i in
  let word = "where" in
  let at = back start - String.length word in
  let last = if has_lines then behind else stop in
  if alone then
    if at > 0 && String.equal (String.sub text at (String.length word)) word then
      Some { from = start; last; cut = (back at, last) }
    else None
  else if before <> "" then None
  else
    let first = with_comments text ~column line in
    let next = min (String.length text) (behind + 1) in
    let cut = if has_lines then (first, next) else (first - 1, stop) in
    Some { from = first + column; last; cut }

(* Can an application be inserted at this place without parentheses? An application that is an
   argument needs them. *)
let is_free_standing text (start, stop) =
  let rec back i = if i > 0 && text.[i - 1] = ' ' then back (i - 1) else i in
  let at = back start in
  let ends word =
    let n = String.length word in
    at > n && String.equal (String.sub text (at - n - 1) (n + 1)) (" " ^ word)
  in
  ((at > 0 && String.contains "=(,[<>+-*/|&" text.[at - 1])
  || List.exists ends [ "if"; "then"; "else"; "in"; "of" ])
  && not (stop < String.length text && text.[stop] = '.')

(* {1 The definition} *)

type found = {
  name : name;
  declaration : declaration;
  signature : declaration option;  (** the definition's own signature *)
  alone : bool;  (** the block contains nothing else *)
}

let local offset tree (start, stop) =
  let is_there (name : name) = offset name.span.start <= start && stop <= offset name.span.stop in
  let signs (name : name) (d : declaration) =
    match d.desc with
    | Signature { names = [ one ]; _ } -> String.equal one.text name.text
    | _ -> false
  in
  let of_mention = function
    | Mentions.Local { declaration = { desc = Binding { left; _ }; _ } as declaration; block } -> (
        match left with
        | (Name name | Function_name { name; _ }) when is_there name ->
            let signature = List.find_opt (signs name) block in
            let others = List.filter (fun d -> d != declaration && Some d <> signature) block in
            Some { name; declaration; signature; alone = others = [] }
        | _ -> None)
    | _ -> None
  in
  List.find_map of_mention (Mentions.of_program tree)

let holds (outer : Span.t) (inner : Span.t) =
  String.equal outer.file inner.file && outer.start <= inner.start && inner.stop <= outer.stop

(* The local variables that the definition uses but does not declare itself, without duplicates. *)
let captured view (d : declaration) =
  let from_around (o : Index.occurrence) =
    o.symbol.what = Local && holds d.span o.place && not (holds d.span o.symbol.at)
  in
  List.fold_left
    (fun names (o : Index.occurrence) ->
      if from_around o && not (List.mem o.symbol.name names) then names @ [ o.symbol.name ]
      else names)
    []
    (Index.all (View.index view))

let is_free ws (doc : Document.t) tree name =
  let is_it (e : Catalogue.entry) = e.space = Mentions.Value && String.equal e.name name in
  let declared = function Mentions.Declares (_, n, _) -> String.equal n.text name | _ -> false in
  let imports = Catalogue.imports (Tokens.of_text (Text.contents doc.text)) in
  not
    (List.exists is_it (Catalogue.in_scope ws doc imports)
    || List.exists declared (Mentions.of_program tree))

(* {1 The change} *)

let checked (ws : Workspace.t) (doc : Document.t) text =
  let a = Workspace.check ws ~path:doc.path text in
  let is_error (d : Diagnostic.t) = d.severity = Error in
  match (View.of_analysis ws.declared a, a.typed) with
  | Some view, Some _ when a.fault = None && not (List.exists is_error a.diagnostics) -> Some view
  | _ -> None

let edits text offset view (top : declaration) found ~parameters ~signature =
  let { name; declaration; _ } = found in
  let range (span : Span.t) = (offset span.start, offset span.stop) in
  let applied_name = String.concat " " (name.text :: parameters) in
  let own = name.span in
  let is_use (o : Index.occurrence) =
    let in_signature (s : declaration) = holds s.span o.place in
    Span.compare o.symbol.at own = 0
    && Span.compare o.place own <> 0
    && not (Option.fold found.signature ~none:false ~some:in_signature)
  in
  let replace (o : Index.occurrence) =
    let at = range o.place in
    (at, if is_free_standing text at then applied_name else "(" ^ applied_name ^ ")")
  in
  let uses = if parameters = [] then [] else List.filter is_use (Index.all (View.index view)) in
  let inside, outside =
    List.partition (fun (o : Index.occurrence) -> holds declaration.span o.place) uses
  in
  let start, stop = range declaration.span in
  let column = Span.column declaration.span.start - 1 in
  let comments_above from start = at_the_edge ~column (String.sub text from (start - from)) in
  (* The comments above the definition, its end, and the ranges to remove. *)
  let pieces =
    match found.signature with
    | None ->
        Option.map
          (fun p -> (comments_above p.from start, p.last, [ p.cut ]))
          (piece text ~alone:found.alone (start, stop))
    | Some s when found.alone ->
        (* The signature and the definition are directly after the `where`, in either order. *)
        let first = min start (fst (range s.span)) in
        Option.map (fun p -> ("", p.last, [ p.cut ])) (piece text ~alone:true (first, stop))
    | Some s -> (
        let signed = fst (range s.span) in
        match (piece text ~alone:false (range s.span), piece text ~alone:false (start, stop)) with
        | Some above, Some p -> Some (comments_above above.from signed, p.last, [ above.cut; p.cut ])
        | _ -> None)
  in
  let change (comments, last, cuts) =
    let here ((a, b), piece) = ((a - start, b - start), piece) in
    let moved =
      applied
        (String.sub text start (last - start))
        (List.map here ((range own, applied_name) :: List.map replace inside))
      |> at_the_edge ~column
    in
    let behind = end_of_line text (offset top.span.stop) in
    ((behind, behind), "\n\n" ^ formatted (comments ^ signature ^ moved))
    :: List.map (fun cut -> (cut, "")) cuts
    @ List.map replace outside
  in
  Option.map change pieces

let at ws (doc : Document.t) view place =
  let open Basis.Let_syntax.Option in
  let a = View.analysis view and tree = View.tree view in
  let text = Text.contents doc.text and offset = Source.offset a.sources a.shown in
  let* found = local offset tree place in
  let* top =
    List.find_opt (fun (d : declaration) -> holds d.span found.declaration.span) tree.declarations
  in
  let name = found.name.text in
  let parameters = captured view found.declaration in
  let attempt signature =
    let* edits = edits text offset view top found ~parameters ~signature in
    let* after = checked ws doc (applied text edits) in
    Some (edits, after)
  in
  if not (is_free ws doc tree name) then None
  else
    let* edits, after = attempt "" in
    let* facts = View.facts after in
    let global = { Resolve.Ir.Global.module_ = (View.program after).main_module; name } in
    let written () =
      match found.signature with
      | Some { span; _ } when parameters = [] ->
          let start, stop = (offset span.start, offset span.stop) in
          let column = Span.column span.start - 1 in
          Some (at_the_edge ~column (String.sub text start (stop - start)))
      | _ ->
          let inferred scheme = Printf.sprintf "%s :: %s" name (Typing.Show.scheme scheme) in
          Option.map inferred (Place_types.global facts global)
    in
    let signed = Option.bind (written ()) (fun signature -> attempt (signature ^ "\n")) in
    Some { name; edits = tidy text (Option.fold signed ~none:edits ~some:fst) }
