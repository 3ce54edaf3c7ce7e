type pass = { name : string; pass : Ir.program -> Ir.program; reason : string }

let all =
  [
    {
      name = "first-instant";
      pass = First_instant.program;
      reason = "first, for its mark may be a field of the root's";
    };
    {
      name = "unused-resets";
      pass = Unused_resets.program;
      reason = "all that resets anything is there";
    };
    {
      name = "field-order";
      pass = Field_order.program;
      reason = "last, when all fields are there";
    };
  ]

let program ?(after = fun _ _ -> ()) program =
  let run program p =
    let made = p.pass program in
    after p made;
    made
  in
  List.fold_left run program all
