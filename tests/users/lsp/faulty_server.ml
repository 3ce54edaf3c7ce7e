(* A language server whose compiler fails. On the module Bug it reports an internal error, on
   Crash it raises an unexpected exception, on Deep it overflows the stack, and on Slow it never
   terminates; its argument is the time limit in seconds. Each of these fails as long as a file of
   that name with the extension [.fault] exists. *)

let rec deep n = 1 + deep (n + 1)
let rec forever list = forever (List.rev list)
let on_disk : Resolve.Files.t = Build.Program_file.files

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
  Language_server.Analysis.patience := float_of_string Sys.argv.(1);
  exit (Language_server.Server.run ~disk ())
