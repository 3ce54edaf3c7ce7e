let map ~stage make all =
  let made = Array.make (Array.length all) None in
  let before k =
    match made.(k) with
    | Some one -> one
    | None -> Diagnostic.bug ~stage "element %d is requested before it is computed" k
  in
  let one k element =
    let one = make ~before k element in
    made.(k) <- Some one;
    one
  in
  Array.mapi one all
