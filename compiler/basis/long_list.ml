let map f list = List.rev (List.rev_map f list)
