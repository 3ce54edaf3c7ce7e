type t = {
  uri : string;
  path : string;
  mutable version : Basis.Json.t;
  mutable text : Text.t;
  mutable latest : Analysis.t option;
  mutable named : View.t option;
  mutable typed : View.t option;
  mutable changed : bool;
}

let opened ~uri ~version text =
  {
    uri; path = Uri.to_path uri; version; text = Text.of_string text; latest = None; named = None;
    typed = None; changed = true;
  }

let change t text =
  t.text <- text;
  t.changed <- true

let looked_at t (a : Analysis.t) =
  t.latest <- Some a;
  t.changed <- false;
  match View.of_analysis a with
  | None -> ()
  | Some view ->
      t.named <- Some view;
      if a.typed <> None then t.typed <- Some view

let seen t = Option.map (fun view -> View.seen view t.text)
let names t = seen t t.named
let types t = seen t t.typed
