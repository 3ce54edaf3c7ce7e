let part part (expected : Expected.t) ty : Expected.t =
  { expected with ty; parts = part :: expected.parts }

let components expected types =
  List.rev
    (snd
       (List.fold_left
          (fun (n, done_) ty -> (n + 1, part (Of_tuple n) expected ty :: done_))
          (1, []) types))
