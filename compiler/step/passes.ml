open Basis

let all =
  [
    Pass.make "first-instant" First_instant.program
      "first, for its mark may be a field of the root's";
    Pass.make "unused-resets" Unused_resets.program "all that resets anything is there";
    Pass.make "field-order" Field_order.program "last, when all fields are there";
  ]

let program ?(after = fun _ _ -> ()) program = List.fold_left (Pass.run after) program all
