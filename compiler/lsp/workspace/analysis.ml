open Basis

type t = {
  path : string;
  text : Text.t;
  shown : string;
  tree : Syntax.Ir.program option;
  diagnostics : Diagnostic.t list;
  sources : Source.t;
  resolved : Resolve.Ir.program option;
  typed : Typing.Ir.program option;
  fault : string option;
}

exception Too_long

(* s *)
let longest = 30.

let with_timer f =
  let set seconds =
    ignore (Unix.setitimer ITIMER_REAL { it_interval = 0.; it_value = seconds })
  in
  let before = Sys.signal Sys.sigalrm (Signal_handle (fun _ -> raise Too_long)) in
  set longest;
  Fun.protect f ~finally:(fun () ->
      set 0.;
      Sys.set_signal Sys.sigalrm before)

let guarded f =
  let broken stage message = Error (Printf.sprintf "internal error in %s: %s" stage message) in
  match with_timer f with
  | value -> Ok value
  | exception Diagnostic.Bug { stage; message } -> broken stage message
  | exception (Too_long | Fun.Finally_raised Too_long) ->
      Error (Printf.sprintf "this takes longer than %.0f s, and was given up" longest)
  | exception Stack_overflow -> broken "frobc" "the stack overflowed"
  | exception Out_of_memory -> broken "frobc" "there is no more memory"
  | exception exn -> broken "frobc" (Printexc.to_string exn)

let path_of ~library shown =
  let folder = Filename.basename library ^ "/" in
  if String.starts_with ~prefix:folder shown then Filename.concat (Filename.dirname library) shown
  else shown

let check ~library ~read ~path text =
  let sink = Diagnostic.sink () and sources = Source.create () in
  let resolved = ref None and typed = ref None in
  let seen : Driver.Front_end.tree -> unit = function
    | Resolved program -> resolved := Some program
    | Typed program -> typed := Some program
  in
  let files = Driver.Program_file.files in
  let read other = if String.equal other path then Ok text else read other in
  let request = Driver.Request.make ~library path in
  (* It is parsed here, once, unless it has to be parsed again for its mistakes. *)
  let tree = ref None in
  let parsed ~file other =
    if not (String.equal other text) then files.parsed ~file other
    else begin
      (tree :=
         match files.parsed ~file text with
         | Some tree -> Some tree
         | None -> Syntax.Parse.program (Diagnostic.sink ()) ~file text);
      !tree
    end
  in
  let request = { request with files = { files with read; parsed } } in
  let fault =
    match guarded (fun () -> Driver.Front_end.check ~seen sink sources request) with
    | Ok () -> None
    | Error fault -> Some fault
  in
  let shown =
    let main (program : Resolve.Ir.program) =
      List.find_opt
        (fun (m : Resolve.Ir.module_) -> String.equal m.name program.main_module)
        program.modules
    in
    match Option.bind !resolved main with Some m -> m.file | None -> path
  in
  {
    path; text = Text.of_string text; shown; tree = !tree; diagnostics = Diagnostic.all sink; sources;
    resolved = !resolved; typed = !typed; fault;
  }
