open Basis

let sound sink typed = if Diagnostic.has_errors sink then None else Some typed

(* The checks of levels and patterns rely on types. After a type error, they would only repeat that
   error in other words. *)
let program ?sources sink facts ~real resolved =
  Option.bind
    (sound sink (Infer.program ?sources sink facts ~real resolved))
    (fun typed ->
      let typed = Levels.program facts typed in
      Patterns.check facts typed;
      sound sink typed)

let partial ~real resolved =
  let sink = Diagnostic.sink () in
  let typed = Infer.program sink (Facts.ignored ()) ~real resolved in
  match Levels.program (Facts.ignored ()) typed with
  | leveled -> leveled
  | exception Diagnostic.Bug _ -> typed
