let mean values = List.fold_left ( +. ) 0. values /. float_of_int (List.length values)

(* Uses the differences from the mean, so that no precision is lost if they are small. *)
let deviation values =
  let middle = mean values and count = List.length values in
  let squares = List.fold_left (fun sum x -> sum +. ((x -. middle) ** 2.)) 0. values in
  sqrt (squares /. float_of_int (count - 1))

let least is_better = function
  | first :: rest ->
      List.fold_left (fun best x -> if is_better (snd x) (snd best) then x else best) first rest
  | [] -> invalid_arg "Spread.least"

let text ?(each = "seed") ~name ~unit_ all =
  let known = List.filter (fun (_, x) -> Float.is_finite x) all in
  let unit_ = if unit_ = "" || unit_ = "1" then "" else " " ^ unit_ in
  let lacking =
    match List.length all - List.length known with
    | 0 -> ""
    | n -> Printf.sprintf "; not measured in %d of %d runs" n (List.length all)
  in
  match known with
  | [] -> Printf.sprintf "%s: not measured" name
  | [ (_, x) ] -> Printf.sprintf "%s: %.4g%s%s" name x unit_ lacking
  | _ ->
      let values = List.map snd known in
      let low_seed, low = least ( < ) known and high_seed, high = least ( > ) known in
      Printf.sprintf "%s: mean %.4g%s, deviation %.3g, from %.4g (%s %d) to %.4g (%s %d)%s" name
        (mean values) unit_ (deviation values) low each low_seed high each high_seed lacking
