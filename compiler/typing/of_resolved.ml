open Basis

let sound facts typed = if Facts.has_errors facts then None else Some typed

(* The checks of levels and patterns rely on types. After a type error, they would only repeat that
   error in other words. *)
let program ?sources facts ~real resolved =
  Option.bind
    (sound facts (Infer.program ?sources facts ~real resolved))
    (fun typed ->
      let typed = Levels.program facts typed in
      Patterns.check facts typed;
      sound facts typed)

let partial ~real resolved =
  let typed = Infer.program (Facts.ignored ()) ~real resolved in
  match Levels.program (Facts.ignored ()) typed with
  | leveled -> leveled
  | exception Diagnostic.Bug _ -> typed
