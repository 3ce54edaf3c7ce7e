(* Shorter ones are mapped on the stack, which makes no list that is thrown away. *)
let short = 1000

let rec map_short left f = function
  | [] -> []
  | list when left = 0 -> List.rev (List.rev_map f list)
  | x :: rest ->
      let y = f x in
      y :: map_short (left - 1) f rest

let map f list = map_short short f list
