let names = Cgen.Robot.names

let known = function
  | None -> Ok ()
  | Some name when List.mem name names -> Ok ()
  | Some name ->
      Error
        (Printf.sprintf "there is no robot `%s`; the robots: %s" name (String.concat ", " names))
