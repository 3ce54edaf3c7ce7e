open Basis
module Ir = Typing.Ir

(* The capability whose instance requests a control of this kind. *)
let capability (control : Core.Ir.control) =
  match control.kind with
  | Hold when String.ends_with ~suffix:" bumper" control.label -> Some "HasBumpers"
  | Lidar _ -> Some "HasLidar"
  | Imu -> Some "HasImu"
  | Camera | Tags -> Some "HasCamera"
  | Hold | Button | Knob _ | Toggle _ | Map -> None

let use (written : Ir.definition) name =
  let is_it ((class_ : Ir.class_), _) =
    match class_ with Declared g -> String.equal g.name name | Eq | Ord -> false
  in
  let asked = List.map2 (fun asked need -> (asked, need)) written.scheme.context written.needs in
  match List.find_opt (fun (asked, _) -> is_it asked) asked with
  | Some (_, (need : Ir.need)) -> need.place
  | None -> written.span

let at_uses (written : Ir.definition) controls =
  let own = written.span.Span.file in
  let at_use (control : Core.Ir.control) =
    match capability control with
    | Some name when not (String.equal control.span.file own) ->
        { control with span = use written name }
    | Some _ | None -> control
  in
  List.map at_use controls
