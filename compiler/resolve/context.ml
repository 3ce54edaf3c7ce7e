open Basis

type t = {
  sink : Diagnostic.sink;
  mutable next_local : int;
  mutable depth : int;
  mutable too_deep : bool;  (** reported *)
  mutable suggestions : int;  (** still to be made *)
  mutable absent : absent list;  (** newest first *)
}

and absent = { imports : string list; code : string; noun : string; name : Syntax.Ir.name }

let create sink =
  { sink; next_local = 0; depth = 0; too_deep = false; suggestions = 100; absent = [] }
let emit t diagnostic = Diagnostic.emit t.sink diagnostic

let fresh t name span : Ir.Local.t =
  let id = t.next_local in
  t.next_local <- id + 1;
  { id; name; span }

let deepest = 10_000

let nested t span ~otherwise f =
  if t.depth >= deepest then begin
    if not t.too_deep then begin
      t.too_deep <- true;
      Diagnostic.error ~code:"E0106" ~at:span "this is nested more than %d levels deep" deepest
      |> Diagnostic.hint "give the inner parts names of their own"
      |> emit t
    end;
    otherwise
  end
  else begin
    t.depth <- t.depth + 1;
    let result = f () in
    t.depth <- t.depth - 1;
    result
  end

let suggest t name candidates diagnostic =
  if t.suggestions = 0 then diagnostic
  else begin
    t.suggestions <- t.suggestions - 1;
    match Suggest.closest name (Lazy.force candidates) with
    | Some near ->
        Diagnostic.hint (Printf.sprintf "did you mean `%s`?" near) diagnostic
        |> Diagnostic.write diagnostic.Diagnostic.at near
    | None -> diagnostic
  end

let not_imported t absent = t.absent <- absent :: t.absent

(* An own line for it, below the imports that are there. *)
let add_import (program : Syntax.Ir.program) declaration =
  let below (span : Span.t) = Span.make ~file:span.file ~start:span.stop ~stop:span.stop in
  let title = Printf.sprintf "add `%s`" declaration in
  match (List.rev program.imports, program.header) with
  | last :: _, _ -> Diagnostic.fix title [ (below last.span, "\n" ^ declaration) ]
  | [], Some header -> Diagnostic.fix title [ (below header.span, "\n\n" ^ declaration) ]
  | [], None ->
      Diagnostic.fix title [ (Span.start_of_file program.file, declaration ^ "\n\n") ]

(* One import is missing, however many names it would bring. *)
let tell_imports t program =
  let by_place a b = Span.compare a.name.span b.name.span in
  let rec tell = function
    | [] -> ()
    | ({ imports; code; noun; name } as first) :: rest ->
        let likewise, rest = List.partition (fun a -> a.imports = imports) rest in
        let names =
          List.map (fun a -> Printf.sprintf "`%s`" a.name.text) (first :: likewise)
          |> List.fold_left (fun all n -> if List.mem n all then all else n :: all) []
          |> List.rev
        in
        Diagnostic.error ~code ~at:name.span "unknown %s `%s`" noun name.text
        |> Diagnostic.hint
             (Printf.sprintf "%s %s in the library: %s" (Enumeration.all names)
                (if List.compare_length_with names 1 = 0 then "is" else "are")
                (String.concat " or " (List.map (Printf.sprintf "`%s`") imports)))
        |> List.fold_right (add_import program) (List.rev imports)
        |> emit t;
        tell rest
  in
  tell (List.sort by_place t.absent);
  t.absent <- []
