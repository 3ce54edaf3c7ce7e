let ( / ) = Filename.concat

open Basis.Let_syntax.Result

let rec all = function
  | [] -> Ok []
  | first :: others ->
      let* first = first in
      Result.map (List.cons first) (all others)

let elementary (resources : Resources.t) =
  let folder = resources.elementary in
  let read name = Result.map (fun text -> (name, text)) (Own_headers.read (folder / name)) in
  all (List.map read (Array.to_list (Sys.readdir folder)))

(* Replaces a header's include directive with the header's text. Headers of robots have their own
   include guards. *)
let line (resources : Resources.t) robot_header line =
  match (String.split_on_char '"' line, robot_header) with
  | [ "#include "; name; "" ], Some (own, text) when String.equal name own -> Ok text
  | _, _ when String.starts_with ~prefix:"#include <frob/" line ->
      let name = Scanf.sscanf line "#include <%[^>]>" Fun.id in
      Own_headers.read (resources.headers / name)
  | _, _ -> Ok line

let files resources ~real (files : Cgen.Emit.t) =
  let* elementary = elementary resources in
  let lines = String.split_on_char '\n' files.header in
  let* lines = all (List.map (line resources files.robot_header) lines) in
  let source = Cgen.Helpers.standalone ~real ~elementary files.source in
  Ok { files with header = String.concat "\n" lines; source; robot_header = None }
