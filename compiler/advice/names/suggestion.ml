open Basis

type t = { mutable left : int }

let create () = { left = 100 }

let add t name candidates diagnostic =
  if t.left = 0 then diagnostic
  else (
    t.left <- t.left - 1;
    match Suggest.closest name (Lazy.force candidates) with
    | Some near ->
        Diagnostic.hint "did you mean `%s`?" near diagnostic
        |> Diagnostic.write diagnostic.Diagnostic.at near
    | None -> diagnostic)
