open Basis

let all =
  [
    Pass.make "first-instant" First_instant.program
      "first, because it may add a field to the root's state";
    Pass.make "short-times" Short_times.program "after all reads of times exist";
    Pass.make "unused-resets" Unused_resets.program "after all statements that reset state exist";
  ]

let program ?(after = fun _ _ -> ()) program = List.fold_left (Pass.run after) program all
