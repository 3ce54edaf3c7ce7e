open Basis

let read path =
  match Resolve.Files.on_disk.read path with
  | Ok text -> text
  | Error _ -> failwith ("cannot read " ^ path)

let directory path = List.sort String.compare (Array.to_list (Sys.readdir path))
let library = "../../../stdlib"

let library_texts =
  lazy
    (List.filter_map
       (fun file ->
         if Filename.check_suffix file ".frob" then
           Some ("stdlib/" ^ file, read (Filename.concat library file))
         else None)
       (directory library))

let load ?(main = "main.frob") files =
  let sink = Diagnostic.sink () in
  let files = Resolve.Files.in_memory (files @ Lazy.force library_texts) in
  let remember ~file:_ _ = () in
  let program =
    Resolve.Program.load (Advice.Of_resolve.into sink) ~files ~remember ~library:"stdlib" main
  in
  Option.iter Resolve.Lint.program program;
  (Diagnostic.all sink, program)

let codes diagnostics = List.map (fun (d : Diagnostic.t) -> d.code) diagnostics
