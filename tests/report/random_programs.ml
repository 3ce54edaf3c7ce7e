(* Writes a module of random programs, with a [main] that runs all of them. *)

let () =
  let argument n = int_of_string Sys.argv.(n) in
  print_string (Fuzz.Program.make ~seed:(argument 1) ~first:0 ~count:(argument 2) ())
