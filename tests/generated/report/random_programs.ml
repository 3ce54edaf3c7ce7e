(* Writes a module of random programs, with a [main] that runs all of them. Their numbers stay
   within the range of single precision. *)

let () =
  let argument n = int_of_string Sys.argv.(n) in
  print_string
    (Fuzz.Constant.in_range Basis.Real.Single
       (Fuzz.Program.make ~seed:(argument 1) ~first:0 ~count:(argument 2) ()))
