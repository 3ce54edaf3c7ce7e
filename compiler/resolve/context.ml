open Basis

type t = {
  sink : Diagnostic.sink;
  mutable next_local : int;
  mutable depth : int;
  mutable too_deep : bool;  (** reported *)
  mutable suggestions : int;  (** still to be made *)
}

let create sink = { sink; next_local = 0; depth = 0; too_deep = false; suggestions = 100 }
let emit t diagnostic = Diagnostic.emit t.sink diagnostic

let fresh t name span : Ir.Local.t =
  let id = t.next_local in
  t.next_local <- id + 1;
  { id; name; span }

let deepest = 10_000

let nested t span ~otherwise f =
  if t.depth >= deepest then begin
    if not t.too_deep then begin
      t.too_deep <- true;
      Diagnostic.error ~code:"E0106" ~at:span "this is nested more than %d levels deep" deepest
      |> Diagnostic.hint "give the inner parts names of their own"
      |> emit t
    end;
    otherwise
  end
  else begin
    t.depth <- t.depth + 1;
    let result = f () in
    t.depth <- t.depth - 1;
    result
  end

let suggest t name candidates diagnostic =
  if t.suggestions = 0 then diagnostic
  else begin
    t.suggestions <- t.suggestions - 1;
    match Suggest.closest name (Lazy.force candidates) with
    | Some near -> Diagnostic.hint (Printf.sprintf "did you mean `%s`?" near) diagnostic
    | None -> diagnostic
  end
