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
exception Not_at_once

let patience = ref 30.

(* After the time limit, the timer raises the exception repeatedly, because a handler may catch it.
   The exception may even interrupt [stop], which is therefore called twice. *)
let with_timer timer signal exn seconds f =
  let armed = ref true in
  let set seconds interval =
    ignore (Unix.setitimer timer { it_interval = interval; it_value = seconds })
  in
  let before = Sys.signal signal (Signal_handle (fun _ -> if !armed then raise exn)) in
  let stop () =
    armed := false;
    set 0. 0.;
    Sys.set_signal signal before
  in
  set seconds 0.02;
  match Fun.protect f ~finally:stop with
  | value -> value
  | exception exn ->
      stop ();
      raise exn

(* Measures processor time, so that other load on the machine does not affect the limit. *)
let at_once f =
  match with_timer ITIMER_PROF Sys.sigprof Not_at_once 0.08 f with
  | value -> Some value
  | exception (Not_at_once | Fun.Finally_raised Not_at_once) -> None

let guarded f =
  let broken stage message = Error (Printf.sprintf "internal error in %s: %s" stage message) in
  match with_timer ITIMER_REAL Sys.sigalrm Too_long !patience f with
  | value -> Ok value
  | exception Diagnostic.Bug { stage; message } -> broken stage message
  | exception (Too_long | Fun.Finally_raised Too_long) ->
      Error (Printf.sprintf "frobc gave up after %.0f s" !patience)
  | exception (Not_at_once | Fun.Finally_raised Not_at_once) -> raise Not_at_once
  | exception Stack_overflow -> broken "frobc" "the stack overflowed"
  | exception Out_of_memory -> broken "frobc" "out of memory"
  | exception exn -> broken "frobc" (Printexc.to_string exn)

let path_of ~library shown =
  let folder = Filename.basename library ^ "/" in
  if String.starts_with ~prefix:folder shown then Filename.concat (Filename.dirname library) shown
  else shown

let name_in ~path (program : Resolve.Ir.program) =
  let is_main (m : Resolve.Ir.module_) = String.equal m.name program.main_module in
  Option.fold (List.find_opt is_main program.modules) ~none:path
    ~some:(fun (m : Resolve.Ir.module_) -> m.file)

(* A request to compile this text as the main module. [parse] supplies its syntax tree. *)
let request ~library ~read ~path text ~parse =
  let files = Build.Program_file.files in
  let read other = if String.equal other path then Ok text else read other in
  let parsed ~file other =
    match files.parsed ~file other with
    | Some tree -> Some tree
    | None -> if String.equal other text then parse ~file text else None
  in
  { (Build.Request.make ~library path) with files = { files with read; parsed } }

let given_up ~path text reason =
  {
    path;
    text = Text.of_string text;
    shown = path;
    tree = None;
    diagnostics = [];
    sources = Source.create ();
    resolved = None;
    typed = None;
    fault = Some reason;
  }

let partial ~library ~read (a : t) =
  let tree = ref None in
  let parse ~file text =
    tree := Syntax.Parse.readable ~file text;
    !tree
  in
  let request = request ~library ~read ~path:a.path (Text.contents a.text) ~parse in
  match guarded (fun () -> Build.Queries.partial a.sources request) with
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
  let seen : Build.Pipeline.tree -> unit = function
    | Resolved program -> resolved := Some program
    | Typed program -> typed := Some program
  in
  (* The text is parsed here, and again only if it has syntax errors. *)
  let tree = ref None in
  let parse ~file text =
    tree := Syntax.Parse.program (Facts.ignored ()) ~file text;
    !tree
  in
  let request = request ~library ~read ~path text ~parse in
  let fault =
    match guarded (fun () -> Build.Queries.check ~seen sink sources request) with
    | Ok () -> None
    | Error fault -> Some fault
  in
  let shown = Option.fold !resolved ~none:path ~some:(name_in ~path) in
  (* For an unmodified library module, the tree is already available. *)
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
