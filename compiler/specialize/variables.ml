include Map.Make (Int)
module Set = Set.Make (Int)
module Table = Basis.Int_table

let restrict keys map =
  Set.fold
    (fun key restricted ->
      match find_opt key map with Some value -> add key value restricted | None -> restricted)
    keys empty
