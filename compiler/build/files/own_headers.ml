type t = { path : string; name : string }

let ( / ) = Filename.concat

open Basis.Let_syntax.Result

(* Joins continued lines. With -std=c99, gcc reads [??/] as a backslash and [??=] as a hash. *)
let joined text =
  let text = Str.global_replace (Str.regexp_string "??/") "\\" text in
  let text = Str.global_replace (Str.regexp_string "??=") "#" text in
  Str.global_replace (Str.regexp "\\\\[ \t]*\r?\n") "" text

(* Replaces each comment with a space, as a C compiler does. An unterminated string or character
   literal ends at the end of its line. *)
let without_comments text =
  let n = String.length text and kept = Buffer.create (String.length text) in
  let at i = if i < n then text.[i] else '\000' in
  let rec code i =
    if i < n then
      match (at i, at (i + 1)) with
      | '/', '*' ->
          Buffer.add_char kept ' ';
          comment (i + 2)
      | '/', '/' -> line_comment (i + 2)
      | (('"' | '\'') as quote), _ ->
          Buffer.add_char kept quote;
          literal quote (i + 1)
      | c, _ ->
          Buffer.add_char kept c;
          code (i + 1)
  and comment i =
    if i < n then if at i = '*' && at (i + 1) = '/' then code (i + 2) else comment (i + 1)
  and line_comment i = if i < n then if at i = '\n' then code i else line_comment (i + 1)
  and literal quote i =
    if i < n then (
      Buffer.add_char kept (at i);
      match at i with
      | '\n' -> code (i + 1)
      | '\\' when i + 1 < n ->
          Buffer.add_char kept (at (i + 1));
          literal quote (i + 2)
      | c -> if c = quote then code (i + 1) else literal quote (i + 1))
  in
  code 0;
  Buffer.contents kept

(* The rest of the line after the directive [name]; [None] if the line is not such a directive. *)
let directive name line =
  let line = String.trim line in
  let after prefix =
    if String.starts_with ~prefix line then
      let n = String.length prefix in
      Some (String.trim (String.sub line n (String.length line - n)))
    else None
  in
  let rest = match after "#" with Some rest -> Some rest | None -> after "%:" in
  match rest with
  | Some rest when String.starts_with ~prefix:name rest ->
      let n = String.length name in
      Some (String.trim (String.sub rest n (String.length rest - n)))
  | Some _ | None -> None

(* Removes code in [#if 0], which no C compiler reads. *)
let without_dead_code lines =
  let is name line = Option.is_some (directive name line) in
  (* [depth]: the nesting depth of conditionals inside the dead code; 0 outside it. *)
  let rec go depth = function
    | [] -> []
    | line :: others when depth = 0 ->
        if directive "if" line = Some "0" then go 1 others else line :: go 0 others
    | line :: others when is "if" line -> go (depth + 1) others
    | line :: others when is "endif" line || (depth = 1 && is "el" line) -> go (depth - 1) others
    | _ :: others -> go depth others
  in
  go 0 lines

(* The name in quotes after an #include. *)
let quoted line =
  match directive "include" line with
  | Some rest when String.starts_with ~prefix:"\"" rest -> (
      match String.split_on_char '"' rest with _ :: name :: _ -> Some name | _ -> None)
  | Some _ | None -> None

let included text =
  joined text |> without_comments |> String.split_on_char '\n' |> without_dead_code
  |> List.filter_map quoted

let read path =
  match open_in_bin path with
  | exception Sys_error reason -> Error ("cannot read " ^ reason)
  | channel ->
      Fun.protect
        ~finally:(fun () -> close_in channel)
        (fun () -> Ok (really_input_string channel (in_channel_length channel)))

let leaves_folder name = List.mem ".." (String.split_on_char '/' name)

(* [within] converts a path relative to the folder of the including file to a path relative to the
   first file. *)
let rec follow found ~who ~within ~folders text =
  List.fold_left
    (fun found include_ ->
      let* found = found in
      match List.find_opt (fun folder -> Sys.file_exists (folder / include_)) folders with
      | None -> Ok found
      | Some _ when leaves_folder include_ || not (Filename.is_relative include_) ->
          Error
            (Printf.sprintf "%s includes \"%s\", which is not in the same folder: move it there" who
               include_)
      | Some folder ->
          let header = { path = folder / include_; name = within include_ } in
          let* text = read header.path in
          let is_same known = String.equal known.name header.name && read known.path = Ok text in
          if List.exists is_same found then Ok found
          else
            let within name =
              match Filename.dirname header.name with "." -> name | inside -> inside / name
            in
            follow (header :: found) ~who:header.path ~within
              ~folders:[ Filename.dirname header.path ]
              text)
    (Ok found) (included text)

let is_header file = List.mem (Filename.extension file) [ ".h"; ".hh"; ".hpp"; ".hxx" ]
let is_file path = Sys.file_exists path && not (Sys.is_directory path)

(* A C compiler first searches the folder of the including file. *)
let beside ~folders file name =
  if not (Filename.is_relative name) then if is_file name then Some name else None
  else
    let within folder = if folder = "." then name else folder / name in
    let paths = List.map within (Filename.dirname file :: folders) in
    List.find_opt is_file paths

let reached ~generated ~folders files =
  let rec visit found file =
    if List.mem file found then found
    else
      let names = match read file with Ok text -> included text | Error _ -> [] in
      let names = List.filter (fun name -> not (List.mem name generated)) names in
      List.fold_left visit (file :: found) (List.filter_map (beside ~folders file) names)
  in
  List.fold_left visit [] files

let includes names ~folders file =
  let names_one file =
    match read file with
    | Ok text -> List.exists (fun name -> List.mem name names) (included text)
    | Error _ -> false
  in
  List.exists names_one (reached ~generated:names ~folders [ file ])

let of_text ~folders text =
  Result.map List.rev (follow [] ~who:"the program" ~within:Fun.id ~folders text)

let of_sources files =
  let one found file =
    let* found = found in
    let* text = read file in
    follow found ~who:file ~within:Fun.id ~folders:[ Filename.dirname file ] text
  in
  Result.map List.rev (List.fold_left one (Ok []) files)
