let ( / ) folder name = if folder = "." then name else Filename.concat folder name

type t = { folders : string list; headers : string list }

type place =
  | Allowed of { path : string; folder : string }
  | C's_own
  | Refused of string (* the path of the refused header *)

(* The file that a C compiler finds first must be allowed, whatever folder it is in. *)
let place ~is_allowed (h : Flow.Ir.header) folders =
  let is_in folder = Sys.file_exists (folder / h.header) in
  match List.find_opt is_in folders with
  | Some folder when is_allowed (folder / h.header) -> Allowed { path = folder / h.header; folder }
  | Some folder -> Refused (folder / h.header)
  | None when C_file.is_standard_header h.header -> C's_own
  | None -> Refused (h.folder / h.header)

let folder = function Allowed { folder; _ } -> Some folder | C's_own | Refused _ -> None
let path = function Allowed { path; _ } -> Some path | C's_own | Refused _ -> None
let refused_path = function Refused path -> Some path | Allowed _ | C's_own -> None

(* Looks for each header in the folder of its module first. When those folders are added to the
   search path, a C compiler may find another file of the same name, so a second pass looks for each
   header in all of these folders. *)
let places ~generated ~sources (headers : Flow.Ir.header list) =
  let given = List.sort_uniq String.compare (List.map Filename.dirname sources) in
  let allowed =
    List.filter_map Included.identity (Own_headers.reached ~generated ~folders:given sources)
  in
  let is_allowed path =
    match Included.identity path with Some id -> List.mem id allowed | None -> false
  in
  let first =
    List.map (fun (h : Flow.Ir.header) -> place ~is_allowed h (given @ [ h.folder ])) headers
  in
  let is_new folder = not (List.mem folder given) in
  let others = List.filter is_new (List.filter_map folder first) in
  let folders = given @ List.sort_uniq String.compare others in
  let last (h : Flow.Ir.header) = function
    | Refused _ as refused -> refused
    | Allowed _ | C's_own -> place ~is_allowed h folders
  in
  (folders, List.map2 last headers first)

let paths_of select places = List.sort_uniq String.compare (List.filter_map select places)

let refused ~generated ~sources headers =
  paths_of refused_path (snd (places ~generated ~sources headers))

let message refused =
  match List.find_opt (fun path -> not (Sys.file_exists path)) refused with
  | Some path ->
      Printf.sprintf "the program includes the C header `%s`, but there is no such file" path
  | None ->
      let s, them = if List.length refused > 1 then ("s", "them") else ("", "it") in
      let option path = Printf.sprintf "--with %s" (Basis.Printable.path path) in
      Printf.sprintf
        "the program includes the C header%s %s, which the command line does not allow: C code can \
         do anything on your computer; if you trust %s, add `%s` (or name a C file that includes \
         %s)"
        s
        (Basis.Enumeration.all (List.map (Printf.sprintf "`%s`") refused))
        them
        (String.concat " " (List.map option refused))
        them

let allowed ~generated ~sources headers =
  let folders, places = places ~generated ~sources headers in
  match paths_of refused_path places with
  | _ :: _ as refused -> Error (message refused)
  | [] -> Ok { folders; headers = paths_of path places }
