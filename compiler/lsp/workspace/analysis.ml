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

let patience = ref 30.

let with_timer f =
  let set seconds = ignore (Unix.setitimer ITIMER_REAL { it_interval = 0.; it_value = seconds }) in
  let before = Sys.signal Sys.sigalrm (Signal_handle (fun _ -> raise Too_long)) in
  set !patience;
  Fun.protect f ~finally:(fun () ->
      set 0.;
      Sys.set_signal Sys.sigalrm before)

let guarded f =
  let broken stage message = Error (Printf.sprintf "internal error in %s: %s" stage message) in
  match with_timer f with
  | value -> Ok value
  | exception Diagnostic.Bug { stage; message } -> broken stage message
  | exception (Too_long | Fun.Finally_raised Too_long) ->
      Error (Printf.sprintf "this takes longer than %.0f s, and was given up" !patience)
  | exception Stack_overflow -> broken "frobc" "the stack overflowed"
  | exception Out_of_memory -> broken "frobc" "there is no more memory"
  | exception exn -> broken "frobc" (Printexc.to_string exn)

let path_of ~library shown =
  let folder = Filename.basename library ^ "/" in
  if String.starts_with ~prefix:folder shown then Filename.concat (Filename.dirname library) shown
  else shown

let name_in ~path (program : Resolve.Ir.program) =
  let is_main (m : Resolve.Ir.module_) = String.equal m.name program.main_module in
  Option.fold (List.find_opt is_main program.modules) ~none:path
    ~some:(fun (m : Resolve.Ir.module_) -> m.file)

(* The main module, as it is read: its text, and perhaps its tree. *)
let request ~library ~read ~path text ~parse =
  let files = Driver.Program_file.files in
  let read other = if String.equal other path then Ok text else read other in
  let parsed ~file other =
    match files.parsed ~file other with
    | Some tree -> Some tree
    | None -> if String.equal other text then parse ~file text else None
  in
  { (Driver.Request.make ~library path) with files = { files with read; parsed } }

let partial ~library ~read (a : t) =
  let tree = ref None in
  let parse ~file text =
    tree := Syntax.Parse.readable ~file text;
    !tree
  in
  let request = request ~library ~read ~path:a.path (Text.contents a.text) ~parse in
  match guarded (fun () -> Driver.Front_end.partial a.sources request) with
  | Ok (Some (resolved, typed)) when !tree <> None ->
      let shown = name_in ~path:a.path resolved in
      let is_it =
        Option.fold !tree ~none:false ~some:(fun (t : Syntax.Ir.program) ->
            String.equal t.file shown)
      in
      let typed = Result.to_option (guarded (fun () -> Lazy.force typed)) in
      if is_it then { a with tree = !tree; shown; resolved = Some resolved; typed } else a
  | Ok _ | Error _ -> a

let check ~library ~read ~path text =
  let sink = Diagnostic.sink () and sources = Source.create () in
  let resolved = ref None and typed = ref None in
  let seen : Driver.Front_end.tree -> unit = function
    | Resolved program -> resolved := Some program
    | Typed program -> typed := Some program
  in
  (* It is parsed here, once, unless it has to be parsed again for its mistakes. *)
  let tree = ref None in
  let parse ~file text =
    tree := Syntax.Parse.program (Diagnostic.sink ()) ~file text;
    !tree
  in
  let request = request ~library ~read ~path text ~parse in
  let fault =
    match guarded (fun () -> Driver.Front_end.check ~seen sink sources request) with
    | Ok () -> None
    | Error fault -> Some fault
  in
  let shown = Option.fold !resolved ~none:path ~some:(name_in ~path) in
  (* A module of the library as it is has its tree already. *)
  let tree =
    match !tree with Some tree -> Some tree | None -> Prepared.Library.tree ~file:shown text
  in
  {
    path;
    text = Text.of_string text;
    shown;
    tree;
    diagnostics = Diagnostic.all sink;
    sources;
    resolved = !resolved;
    typed = !typed;
    fault;
  }
