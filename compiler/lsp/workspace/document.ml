type version = { view : View.t; whole : bool; mutable since : Shift.t }

type t = {
  uri : string;
  path : string;
  mutable version : Basis.Json.t;
  mutable text : Text.t;
  mutable latest : Analysis.t option;
  mutable named : version option;
  mutable typed : version option;
  mutable changed : bool;
  mutable slow : bool;
}

let opened ~uri ~version text =
  {
    uri;
    path = Uri.to_path uri;
    version;
    text = Text.of_string text;
    latest = None;
    named = None;
    typed = None;
    changed = true;
    slow = false;
  }

(* Maximum number of edits that are stored separately. If there are more, they are merged into
   one. *)
let most_steps = 200

let change t text =
  let step = Shift.between (Text.contents t.text) (Text.contents text) in
  let changed version =
    version.since <-
      (if List.compare_length_with version.since most_steps < 0 then
         Shift.and_then version.since step
       else
         let before = Text.contents (View.analysis version.view).text in
         Shift.between before (Text.contents text))
  in
  Option.iter changed t.named;
  Option.iter changed t.typed;
  t.text <- text;
  t.changed <- true

let is_whole = function Some { whole; _ } -> whole | None -> false

type found = { analysis : Analysis.t; whole_view : View.t option; partial_view : View.t option }

let found t ~declared ~partial (a : Analysis.t) =
  let whole_view = View.of_analysis declared a in
  let named = Option.is_some whole_view || is_whole t.named in
  let typed = Option.is_some a.typed || is_whole t.typed in
  let partial_view = if named && typed then None else View.of_analysis declared (partial a) in
  { analysis = a; whole_view; partial_view }

let prepare { whole_view; partial_view; _ } =
  Option.iter View.prepare whole_view;
  Option.iter View.prepare partial_view

let looked_at t { analysis; whole_view; partial_view } =
  t.latest <- Some analysis;
  t.changed <- false;
  let version view ~whole before =
    match view with Some view -> Some { view; whole; since = Shift.none } | None -> before
  in
  t.named <- version whole_view ~whole:true t.named;
  if analysis.typed <> None then t.typed <- version whole_view ~whole:true t.typed;
  let understood view =
    if not (is_whole t.named) then t.named <- version (Some view) ~whole:false t.named;
    if (not (is_whole t.typed)) && (View.analysis view).typed <> None then
      t.typed <- version (Some view) ~whole:false t.typed
  in
  Option.iter understood partial_view

let seen t = Option.map (fun { view; since } -> View.seen view t.text since)
let names t = seen t t.named
let types t = seen t t.typed
