(* Each fix that a diagnostic of the corpus comes with is made alone, and the program looked
   at again: the diagnostic has to be gone from there. Prints those that failed. *)

open Basis

let () =
  let library = Sys.argv.(1) in
  let count = ref 0 in
  let failed = ref [] in
  let like (d : Diagnostic.t) (other : Diagnostic.t) =
    String.equal d.code other.code && String.equal d.message other.message
  in
  let try_fix path all sources (d : Diagnostic.t) (fix : Diagnostic.fix) =
    incr count;
    let after, made = Driver.Fix_files.applied sources ~file:"program.frob" [ fix ] in
    let left, sources' = Corpus.check ~library after in
    let number list = List.length (List.filter (like d) list) in
    (* One further behind was only not reached before. *)
    let is_there (other : Diagnostic.t) = like d other && other.at.start <= d.at.start in
    if made = [] || (number left >= number all && List.exists is_there left) then
      failed :=
        Printf.sprintf "%s: %s after `%s`\n%s%s" (Filename.basename path) d.code fix.title
          (Render_text.diagnostics ~colour:false sources [ d ])
          (Render_text.diagnostics ~colour:false sources' left)
        :: !failed
  in
  Corpus.each (fun ~path ~text:_ all sources d -> List.iter (try_fix path all sources d) d.fixes);
  List.iter print_endline (List.rev !failed);
  if !count < 100 then Printf.printf "only %d fixes: is the corpus here?\n" !count;
  exit (if !failed = [] && !count >= 100 then 0 else 1)
