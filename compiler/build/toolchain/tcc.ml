let own = "frob-tcc"
let is_own compiler = Filename.basename compiler = own

let is_named compiler =
  let name = Filename.basename compiler in
  is_own name || name = "tcc"
  || String.starts_with ~prefix:"tcc-" name
  || String.ends_with ~suffix:"-tcc" name

let archive file =
  if Filename.basename file = "libfrob.a" then
    Filename.concat (Filename.dirname file) "libfrob-tcc.a"
  else file

(* Works around two bugs of tcc 0.9.27. When a function returns a struct in registers, the caller
   writes whole registers. If the size of the struct is not a multiple of the size of a register,
   this overwrites the variable after the struct. So we pad all structs to such a multiple. Also, tcc
   does not recognize a sum that contains NaN or infinity as a constant, so local tables become
   variables. *)
let adapted text =
  let starts_struct line =
    String.starts_with ~prefix:"struct " line && String.ends_with ~suffix:"{" line
  in
  let table = "static const " in
  let adapted_line after_start line =
    let indented = String.trim line in
    let is_local = String.length indented < String.length line in
    let from = String.length table in
    if after_start then "_Alignas(8) " ^ indented
    else if is_local && String.starts_with ~prefix:table indented then
      "const " ^ String.sub indented from (String.length indented - from)
    else line
  in
  let rec go after_start = function
    | [] -> []
    | line :: lines -> adapted_line after_start line :: go (starts_struct line) lines
  in
  String.concat "\n" (go false (String.split_on_char '\n' text))
