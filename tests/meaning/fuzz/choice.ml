let chance random n = Random.State.int random n = 0
let one_of random list = List.nth list (Random.State.int random (List.length list))

let weighted random list =
  let total = List.fold_left (fun sum (weight, _) -> sum + weight) 0 list in
  let rec pick n = function
    | [] -> invalid_arg "Choice.weighted"
    | (weight, x) :: others -> if n < weight then x else pick (n - weight) others
  in
  pick (Random.State.int random total) list

let shuffled random list =
  List.map (fun x -> (Random.State.bits random, x)) list
  |> List.sort (fun (a, _) (b, _) -> Int.compare a b)
  |> List.map snd
