let included =
  "#include <frob/step.h> /* in share/frobc/include; `--standalone` puts it in here */\n"

(* {1 Pieces of C} *)

let is_word = function 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' -> true | _ -> false

(* Rewrites C code: applies [word] to each identifier and [comment] to each comment. *)
let rewritten ~word ~comment text =
  let out = Buffer.create (String.length text) and n = String.length text in
  let rec word_end k = if k < n && is_word text.[k] then word_end (k + 1) else k in
  let rec comment_end k =
    if k >= n || (text.[k - 2] = '*' && text.[k - 1] = '/') then k else comment_end (k + 1)
  in
  let rec from k =
    if k < n then
      if k + 1 < n && text.[k] = '/' && text.[k + 1] = '*' then
        piece comment k (comment_end (k + 4))
      else if is_word text.[k] then
        piece (match text.[k] with '0' .. '9' -> Fun.id | _ -> word) k (word_end k)
      else piece Fun.id k (k + 1)
  and piece f start stop =
    Buffer.add_string out (f (String.sub text start (stop - start)));
    from stop
  in
  from 0;
  Buffer.contents out

let code text = String.trim (rewritten ~word:Fun.id ~comment:(fun _ -> "") text)

let identifiers text =
  let found = ref [] in
  let word name =
    found := name :: !found;
    name
  in
  ignore (rewritten ~word ~comment:(fun _ -> "") text : string);
  List.rev !found

type piece = {
  text : string;
  code : string;  (** the text without comments *)
  defines : string option;
  is_function : bool;
}

(* A piece with the name that it defines. For a directive, this is the name of the macro, or the
   first name that starts with FROB_ in the condition. For other definitions, it is the last name
   before the value, the parameters or the members. *)
let piece text =
  let code = code text in
  let before c = Option.value (String.index_opt code c) ~default:(String.length code) in
  let value = min (before '{') (min (before '=') (before '[')) in
  let is_directive = String.starts_with ~prefix:"#" code in
  let rec macro = function
    | "define" :: name :: _ -> Some name
    | _ :: rest -> macro rest
    | [] -> List.find_opt (String.starts_with ~prefix:"FROB_") (identifiers code)
  in
  let last = List.fold_left (fun _ name -> Some name) None in
  let defines =
    if is_directive then macro (identifiers code)
    else last (identifiers (String.sub code 0 (min value (before '('))))
  in
  { text; code; defines; is_function = (not is_directive) && before '(' < value }

(* Splits C code at the blank lines outside braces. *)
let pieces text =
  let depth text =
    let count sum = function '{' -> sum + 1 | '}' -> sum - 1 | _ -> sum in
    String.fold_left count 0 (code text)
  in
  let add (pieces, rest) line =
    if line <> "" || depth rest > 0 then (pieces, String.concat "" [ rest; line; "\n" ])
    else if rest = "" then (pieces, "")
    else (piece rest :: pieces, "")
  in
  List.rev (fst (List.fold_left add ([], "") (String.split_on_char '\n' (text ^ "\n"))))

let has_word word piece = List.mem word (identifiers piece.code)
let step = lazy (List.partition (has_word "error") (pieces Step_header.text))
let names () = List.filter_map (fun piece -> piece.defines) (snd (Lazy.force step))

(* {1 Standalone files} *)

let included_file line =
  match String.split_on_char '"' line with [ "#include "; file; "" ] -> Some file | _ -> None

(* The pieces of the files for one precision. Each file comes after the files that it includes. *)
let elementary_pieces ~(real : Basis.Real.t) files =
  let is_single (file, _) = String.starts_with ~prefix:"single" file in
  let files = List.filter (fun f -> is_single f = (real = Single)) (List.sort compare files) in
  let rec visit seen file =
    match List.assoc_opt file files with
    | Some text when not (List.mem_assoc file seen) ->
        let inner = List.filter_map included_file (String.split_on_char '\n' text) in
        (file, pieces text) :: List.fold_left visit seen inner
    | Some _ | None -> seen
  in
  let sources = List.filter (fun (file, _) -> Filename.check_suffix file ".c") files in
  let all = List.rev (List.fold_left visit [] (List.map fst sources)) in
  List.filter (fun p -> not (has_word "include" p || has_word "ifndef" p)) (List.concat_map snd all)

(* Makes functions static, and adds a prefix to all names so that they do not clash with the
   program's. *)
let own pieces =
  let defined = List.filter_map (fun p -> p.defines) pieces in
  let rename name =
    if List.mem name defined && not (String.starts_with ~prefix:"frob_" name) then "frob_" ^ name
    else name
  in
  let renamed p =
    let p = piece (rewritten ~word:rename ~comment:Fun.id p.text) in
    if (not p.is_function) || String.starts_with ~prefix:"static" p.code then p
    else
      let comments = ref "" in
      let comment text =
        comments := String.concat "" [ !comments; text; "\n" ];
        ""
      in
      ignore (rewritten ~word:Fun.id ~comment (List.hd (String.split_on_char '{' p.text)) : string);
      let behind = String.length !comments in
      let definition = String.sub p.text behind (String.length p.text - behind) in
      piece (String.concat "" [ !comments; "static "; definition ])
  in
  List.map renamed pieces

(* The pieces that the C code in [text] needs, directly or indirectly. *)
let needed pieces text =
  let wanted = Hashtbl.create 64 and taken = Hashtbl.create 16 in
  let want text = List.iter (fun name -> Hashtbl.replace wanted name ()) (identifiers text) in
  want text;
  let take k p =
    match p.defines with
    | Some name when Hashtbl.mem wanted name && not (Hashtbl.mem taken k) ->
        Hashtbl.replace taken k ();
        want p.code;
        true
    | Some _ | None -> false
  in
  let rec close () = if List.mem true (List.mapi take pieces) then close () in
  close ();
  List.filteri (fun k _ -> Hashtbl.mem taken k) pieces

let prototype p = String.trim (List.hd (String.split_on_char '{' p.code)) ^ ";\n"

(* The parts of the source before and after its include directive. *)
let around_include source =
  let n = String.length included in
  let rec from k =
    if String.equal (String.sub source k n) included then
      (String.sub source 0 k, String.sub source (k + n) (String.length source - k - n))
    else from (k + 1)
  in
  from 0

let standalone ~real ~elementary source =
  let checks, step = Lazy.force step in
  let elementary = needed (own (elementary_pieces ~real elementary)) source in
  let is_included_by_c line =
    String.starts_with ~prefix:"#include <" line
    && not (String.starts_with ~prefix:"#include <frob/" line)
  in
  let includes = List.filter is_included_by_c (String.split_on_char '\n' Step_header.text) in
  let called = identifiers source in
  let is_called p = p.is_function && List.mem (Option.get p.defines) called in
  let prototypes = List.map prototype (List.filter is_called elementary) in
  let texts = List.map (fun p -> p.text) in
  let before, program = around_include source in
  String.concat "\n"
    (((before ^ String.concat "\n" includes ^ "\n") :: texts (checks @ needed step source))
    @ (if prototypes = [] then [] else [ String.concat "" prototypes ])
    @ ((String.trim program ^ "\n") :: texts elementary))
