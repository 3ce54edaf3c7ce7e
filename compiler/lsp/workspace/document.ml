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
  }

(* So many one after the other are remembered; then all are taken for one. *)
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

let looked_at t ~partial (a : Analysis.t) =
  t.latest <- Some a;
  t.changed <- false;
  let version view ~whole before =
    match view with Some view -> Some { view; whole; since = Shift.none } | None -> before
  in
  let view = View.of_analysis a in
  t.named <- version view ~whole:true t.named;
  if a.typed <> None then t.typed <- version view ~whole:true t.typed;
  if not (is_whole t.named && is_whole t.typed) then (
    let understood = partial a in
    let view = View.of_analysis understood in
    if not (is_whole t.named) then t.named <- version view ~whole:false t.named;
    if (not (is_whole t.typed)) && understood.typed <> None then
      t.typed <- version view ~whole:false t.typed)

let seen t = Option.map (fun { view; since } -> View.seen view t.text since)
let names t = seen t t.named
let types t = seen t t.typed
