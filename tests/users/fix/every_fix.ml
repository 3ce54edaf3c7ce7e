(* Applies each fix of the diagnostics in the corpus separately and checks the program again: the
   diagnostic must have disappeared from that place. Also applies each fix to the same program with
   a comment after every line: all comments must remain, in the same order. Prints the fixes that
   fail. *)

open Basis

let () =
  let library = Sys.argv.(1) in
  let count = ref 0 in
  let failed = ref [] in
  let like (d : Diagnostic.t) (other : Diagnostic.t) =
    String.equal d.code other.code && d.message = other.message
  in
  let try_fix path all sources (d : Diagnostic.t) (fix : Diagnostic.fix) =
    incr count;
    let after, made = Tools.Fix_files.applied sources ~file:"program.frob" [ fix ] in
    let left, sources' = Corpus.check ~library after in
    let number list = List.length (List.filter (like d) list) in
    (* A diagnostic further on does not count: the compiler may not have reached it before. *)
    let is_there (other : Diagnostic.t) = like d other && other.at.start <= d.at.start in
    if made = [] || (number left >= number all && List.exists is_there left) then
      failed :=
        Printf.sprintf "%s: %s after `%s`\n%s%s" (Filename.basename path) d.code
          (Diagnostic.for_display fix.title)
          (Render_text.diagnostics ~colour:false sources [ d ])
          (Render_text.diagnostics ~colour:false sources' left)
        :: !failed
  in
  let tried = Hashtbl.create 64 in
  let try_comments path text =
    let mark k = Printf.sprintf " -- c%d\n" k in
    let lines = String.split_on_char '\n' text in
    let text = String.concat "" (List.mapi (fun k line -> line ^ mark k) lines) in
    let all, sources = Corpus.check ~library text in
    let try_fix (d : Diagnostic.t) (fix : Diagnostic.fix) =
      let after, _ = Tools.Fix_files.applied sources ~file:"program.frob" [ fix ] in
      let words = List.concat_map (String.split_on_char '\n') (String.split_on_char ' ' after) in
      let is_lost k = not (List.mem (Printf.sprintf "c%d" k) words) in
      if List.exists is_lost (List.init (List.length lines) Fun.id) then
        failed :=
          Printf.sprintf "%s: %s: a comment is lost after `%s`\n%s" (Filename.basename path) d.code
            (Diagnostic.for_display fix.title)
            after
          :: !failed
    in
    List.iter (fun (d : Diagnostic.t) -> List.iter (try_fix d) d.fixes) all
  in
  Corpus.each (fun ~path ~text all sources d ->
      if not (Hashtbl.mem tried text) then (
        Hashtbl.add tried text ();
        try_comments path text);
      List.iter (try_fix path all sources d) d.fixes);
  List.iter print_endline (List.rev !failed);
  if !count < 100 then Printf.printf "only %d fixes: is the corpus here?\n" !count;
  exit (if !failed = [] && !count >= 100 then 0 else 1)
