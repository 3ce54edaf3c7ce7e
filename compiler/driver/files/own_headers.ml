type t = { path : string; name : string }

let ( / ) = Filename.concat
let ( let* ) = Result.bind

(* What stands in quotes after an #include. *)
let quoted line =
  let line = String.trim line in
  let starts prefix text =
    if String.starts_with ~prefix text then
      let n = String.length prefix in
      Some (String.trim (String.sub text n (String.length text - n)))
    else None
  in
  match Option.bind (starts "#" line) (starts "include") with
  | Some rest when String.starts_with ~prefix:"\"" rest -> (
      match String.split_on_char '"' rest with _ :: name :: _ -> Some name | _ -> None)
  | Some _ | None -> None

let included text = List.filter_map quoted (String.split_on_char '\n' text)

let read path =
  match open_in_bin path with
  | exception Sys_error reason -> Error ("cannot read " ^ reason)
  | channel ->
      Fun.protect
        ~finally:(fun () -> close_in channel)
        (fun () -> Ok (really_input_string channel (in_channel_length channel)))

let leaves_folder name = List.mem ".." (String.split_on_char '/' name)

(* [within]: where the including file stands among the others. *)
let rec follow found ~who ~within ~folders text =
  List.fold_left
    (fun found include_ ->
      let* found = found in
      match List.find_opt (fun folder -> Sys.file_exists (folder / include_)) folders with
      | None -> Ok found
      | Some _ when leaves_folder include_ || not (Filename.is_relative include_) ->
          Error
            (Printf.sprintf "%s includes \"%s\", which is not in its folder: put it there" who
               include_)
      | Some folder ->
          let header = { path = folder / include_; name = within include_ } in
          if List.exists (fun known -> String.equal known.name header.name) found then Ok found
          else
            let* text = read header.path in
            let within name =
              match Filename.dirname header.name with "." -> name | inside -> inside / name
            in
            follow (header :: found) ~who:header.path ~within
              ~folders:[ Filename.dirname header.path ]
              text)
    (Ok found) (included text)

let of_text ~folders text =
  Result.map List.rev (follow [] ~who:"the program" ~within:Fun.id ~folders text)

let of_sources files =
  let one found file =
    let* found = found in
    let* text = read file in
    follow found ~who:file ~within:Fun.id ~folders:[ Filename.dirname file ] text
  in
  Result.map List.rev (List.fold_left one (Ok []) files)
