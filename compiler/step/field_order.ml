let program (program : Ir.program) =
  let largest = Array.make (Array.length program.nodes) 1 in
  let rec alignment (field : Ir.field) =
    match field.content with
    | Value ty -> (Block.of_value program.real program.sums ty).alignment
    | Running_mode -> 1
    | Component _ -> Block.foreign.alignment
    | Modes modes -> of_fields (List.concat_map State.fields_of_mode modes)
    | State_of k | States_of { node = k; _ } -> largest.(k)
  and of_fields fields = List.fold_left (fun most f -> max most (alignment f)) 1 fields in
  let is_time (field : Ir.field) =
    match field.content with Value Nanoseconds -> true | _ -> false
  in
  let by_alignment a b = compare (alignment b, is_time a) (alignment a, is_time b) in
  let node k (node : Ir.node) =
    largest.(k) <- of_fields node.state;
    { node with state = List.stable_sort by_alignment node.state }
  in
  { program with nodes = Array.mapi node program.nodes }
