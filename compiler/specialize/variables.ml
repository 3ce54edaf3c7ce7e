include Map.Make (Int)
module Set = Set.Make (Int)

module Table = Hashtbl.Make (struct
  type t = int

  let equal = Int.equal
  let hash n = n land max_int
end)

let restrict keys map =
  Set.fold
    (fun key restricted ->
      match find_opt key map with
      | Some value -> add key value restricted
      | None -> restricted)
    keys empty
