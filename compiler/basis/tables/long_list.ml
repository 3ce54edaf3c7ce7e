(* Lists up to this length are mapped recursively, which avoids an intermediate list. *)
let short = 1000

let rec map_short left f = function
  | [] -> []
  | list when left = 0 -> List.rev (List.rev_map f list)
  | x :: rest ->
      let y = f x in
      y :: map_short (left - 1) f rest

let map f list = map_short short f list

let rec map_short_sharing left f list =
  match list with
  | [] -> list
  | _ when left = 0 ->
      let mapped = List.rev_map f list in
      if List.for_all2 ( == ) (List.rev list) mapped then list else List.rev mapped
  | x :: rest ->
      let y = f x in
      let mapped = map_short_sharing (left - 1) f rest in
      if y == x && mapped == rest then list else y :: mapped

let map_sharing f list = map_short_sharing short f list

let split_at count list =
  let rec go before count = function
    | x :: rest when count > 0 -> go (x :: before) (count - 1) rest
    | rest -> (List.rev before, rest)
  in
  go [] count list

let map2 f a b = List.rev (List.rev_map2 f a b)
