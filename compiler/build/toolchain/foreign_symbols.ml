open Basis

let is_part = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false

(* Whether a name occurs as a separate word: in C code, or in the symbol table of an object file. *)
let mentions text name =
  let n = String.length name in
  let is_free k = k < 0 || k >= String.length text || not (is_part text.[k]) in
  let rec from k =
    match String.index_from_opt text k name.[0] with
    | Some k when k + n > String.length text -> false
    | Some k when String.sub text k n = name && is_free (k - 1) && is_free (k + n) -> true
    | Some k -> from (k + 1)
    | None -> false
  in
  from 0

let is_free_to_call name = C_names.is_pure name || Kernels.is_known name

(* Whether the texts mention the function, or the functions of a component with this name. *)
let gives texts name =
  let has name = List.exists (fun text -> mentions text name) texts in
  has name || (has (name ^ "_reset") && has (name ^ "_step"))

let giving ~calls files =
  let wanted = List.filter (fun name -> not (is_free_to_call name)) calls in
  let is_giving file =
    match Own_headers.read file with
    | Ok text -> List.exists (gives [ text ]) wanted
    | Error _ -> false
  in
  List.filter is_giving files

let unknown ~calls files =
  (* The C compiler reports files that cannot be read. *)
  let texts = List.filter_map (fun file -> Result.to_option (Own_headers.read file)) files in
  let is_known name = is_free_to_call name || gives texts name in
  List.filter (fun name -> not (is_known name)) calls

let check ~calls files =
  match unknown ~calls files with
  | [] -> Ok ()
  | unknown ->
      Error
        (Printf.sprintf
           "the program calls %s in C, %s: add the C files with `--with FILE.c` (only the \
            functions of <math.h> that docs/foreign.md lists need no file)"
           (String.concat ", " (List.map (Printf.sprintf "`%s`") unknown))
           (if files = [] then "but there is no C file" else "but none of its C files mentions it"))
