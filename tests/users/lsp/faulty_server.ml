(* A language server whose compiler breaks: on reading the module Bug it finds a broken promise of
   its own, on Crash it raises what nobody foresaw, on Deep it overflows the stack, and with Slow
   it does not come to an end, for which it has 1 s. Each goes wrong while the file is there that
   is called so, with the ending [.fault]. *)

let rec deep n = 1 + deep (n + 1)
let rec forever list = forever (List.rev list)
let on_disk : Resolve.Files.t = Driver.Program_file.files

let disk path =
  if Sys.file_exists (Filename.remove_extension path ^ ".fault") then
    match Filename.remove_extension (Filename.basename path) with
    | "Bug" -> Basis.Diagnostic.bug ~stage:"Files" "nobody knows why"
    | "Crash" -> raise Not_found
    | "Deep" -> Ok (string_of_int (deep 0))
    | "Slow" -> forever [ 1; 2 ]
    | _ -> on_disk.read path
  else on_disk.read path

let () =
  Language_server.Analysis.patience := 1.;
  exit (Language_server.Server.run ~disk ())
