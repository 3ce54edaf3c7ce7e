let option = "-H"
let in_folder folder = Filename.concat folder "."

(* A line starts with one dot for each level of inclusion: `.. PATH` is included by a file that the
   main file includes. *)
let listed line =
  let n = String.length line in
  let rec depth i = if i < n && line.[i] = '.' then depth (i + 1) else i in
  let depth = depth 0 in
  if depth > 0 && depth < n && line.[depth] = ' ' then
    Some (depth, String.sub line (depth + 1) (n - depth - 1))
  else None

let lines = String.split_on_char '\n'

(* For each file that it compiles, gcc may suggest include guards: it prints a line that says so,
   and then the path of each header on a separate line. *)
let other_lines output =
  let is_message line = String.contains line ':' || String.contains line '^' || line = "" in
  let rec without_suggestions ~inside = function
    | [] -> []
    | line :: others when String.starts_with ~prefix:"Multiple include guards" line ->
        without_suggestions ~inside:true others
    | line :: others when inside && not (is_message line) -> without_suggestions ~inside:true others
    | line :: others -> line :: without_suggestions ~inside:false others
  in
  lines output
  |> List.filter (fun line -> Option.is_none (listed line))
  |> without_suggestions ~inside:false |> String.concat "\n"

let lists_some output = List.exists (fun line -> Option.is_some (listed line)) (lines output)

let identity path =
  match Unix.stat path with s -> Some (s.st_dev, s.st_ino) | exception Unix.Unix_error _ -> None

let check ~allowed ~sources ~folders output =
  let allowed = List.filter_map identity allowed in
  let is_named path = match identity path with Some id -> List.mem id allowed | None -> false in
  let is_in folder path = String.starts_with ~prefix:(Filename.concat folder "") path in
  let own = List.map (fun file -> in_folder (Filename.dirname file)) sources in
  let is_found path = List.exists (fun folder -> is_in (in_folder folder) path) folders in
  (* [above]: the allowed files that include this one, innermost first, each with its depth. *)
  let rec visit above = function
    | [] -> Ok ()
    | (depth, path) :: others ->
        let above = List.filter (fun (d, _) -> d < depth) above in
        let beside =
          match above with
          | (d, parent) :: _ when d = depth - 1 -> is_in (Filename.dirname parent) path
          | _ -> depth = 1 && List.exists (fun folder -> is_in folder path) own
        in
        if (not (is_found path)) || is_named path || beside then
          visit ((depth, path) :: above) others
        else
          let path =
            List.fold_left
              (fun path folder ->
                if is_in (in_folder folder) path then
                  let n = String.length (Filename.concat (in_folder folder) "") in
                  let name = String.sub path n (String.length path - n) in
                  if folder = "." then name else Filename.concat folder name
                else path)
              path folders
          in
          Error
            (Printf.sprintf
               "the C compiler includes the file `%s`, which the command line does not allow: C \
                code can do anything on your computer; if you trust it, add `--with %s`; otherwise \
                rename your header, or include the standard one as <%s>"
               path (Basis.Printable.path path) (Filename.basename path))
  in
  visit [] (List.filter_map listed (lines output))
