let rec evaluate thunk =
  match (Thunk.demand thunk : Value.t) with
  | Tuple parts | Array parts | Data { arguments = parts; _ } -> Array.iter evaluate parts
  | Drawing marks -> List.iter evaluate marks
  | Bool _ | Int _ | Float _ | Text _ | Image _ | Function _ | Signal_function _ | Task _ | Ending _
    ->
      ()
