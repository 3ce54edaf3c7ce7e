open Ir

let is_stateful = function
  | Delay _ | Time _ | Step_time | Ticks _ | Integral _ | Derivative _ -> true
  | Copy _ | Op _ | If _ | Construct _ | Is_constructor _ | Payload _ | Elements _ | Param _
  | Absent | Fill _ | Index _ | At _ | Replace _ ->
      false
