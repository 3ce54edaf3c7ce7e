open Basis

let is_part = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false

(* As a word of its own: a name in C, or in an object's table of names. *)
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

(* It, or what makes a signal function of it. *)
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

let check ~calls ~sources ~header ~folders =
  (* What cannot be read is the C compiler's to tell. *)
  let headers = function
    | Ok headers -> List.map (fun (h : Own_headers.t) -> h.path) headers
    | Error _ -> []
  in
  let files =
    sources
    @ headers (Own_headers.of_sources sources)
    @ headers (Own_headers.of_text ~folders header)
  in
  let texts = List.filter_map (fun file -> Result.to_option (Own_headers.read file)) files in
  let is_known name = is_free_to_call name || gives texts name in
  match List.filter (fun name -> not (is_known name)) calls with
  | [] -> Ok ()
  | unknown ->
      Error
        (Printf.sprintf
           "the program calls %s in C, %s: name the C files with `--with FILE.c` (without a file \
            there are only the functions of <math.h> that docs/foreign.md lists)"
           (String.concat ", " (List.map (Printf.sprintf "`%s`") unknown))
           (if files = [] then "and there is no C file" else "which no C file of it mentions"))
