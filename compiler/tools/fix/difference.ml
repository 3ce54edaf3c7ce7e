type line = Kept of string | Removed of string | Added of string

(* The lines without their line feeds, so that a missing line feed at the end makes no
   difference. *)
let lines text =
  match List.rev (String.split_on_char '\n' text) with
  | "" :: rest -> Array.of_list (List.rev rest)
  | all -> Array.of_list (List.rev all)

(* Returns one table [reach] for each number [d] of changes: [reach.(k)] is the end of the
   furthest-reaching path with [d] changes on the diagonal [k] (Myers, An O(ND) Difference
   Algorithm, 1986, section 4). *)
let rows a b =
  let n = Array.length a and m = Array.length b in
  let most = n + m in
  let rec go d before rows =
    let reach = Hashtbl.create (2 * (d + 1)) in
    let at k = Option.value (Hashtbl.find_opt before k) ~default:0 in
    let rec each k =
      if k > d then None
      else
        let down = k = -d || (k <> d && at (k - 1) < at (k + 1)) in
        let x = if d = 0 then 0 else if down then at (k + 1) else at (k - 1) + 1 in
        let rec slide x =
          let y = x - k in
          if x < n && y < m && String.equal a.(x) b.(y) then slide (x + 1) else x
        in
        let x = slide x in
        Hashtbl.replace reach k x;
        if x >= n && x - k >= m then Some () else each (k + 2)
    in
    match each (-d) with
    | Some () -> (reach :: rows, d)
    | None when d >= most -> (reach :: rows, d)
    | None -> go (d + 1) reach (reach :: rows)
  in
  go 0 (Hashtbl.create 1) []

let changes a b =
  let rows, d = rows a b in
  let rec back x y d rows found =
    match rows with
    | [] | [ _ ] ->
        let rec kept x found = if x = 0 then found else kept (x - 1) (Kept a.(x - 1) :: found) in
        kept x found
    | _ :: (before :: _ as rest) ->
        let at k = Option.value (Hashtbl.find_opt before k) ~default:0 in
        let k = x - y in
        let down = k = -d || (k <> d && at (k - 1) < at (k + 1)) in
        let from = if down then k + 1 else k - 1 in
        let x' = at from in
        let y' = x' - from in
        let start = if down then x' else x' + 1 in
        let rec kept i found =
          if i = start then found else kept (i - 1) (Kept a.(i - 1) :: found)
        in
        let found = kept x found in
        let change = if down then Added b.(y') else Removed a.(x') in
        back x' y' (d - 1) rest (change :: found)
  in
  back (Array.length a) (Array.length b) d rows []

let context = 3

(* Start and end of each hunk: nearby changes with [context] lines around them. *)
let hunks changes =
  let all = Array.of_list changes in
  let is_change = function Kept _ -> false | Removed _ | Added _ -> true in
  let n = Array.length all in
  let near i =
    let rec any j = j <= min (n - 1) (i + context) && (is_change all.(j) || any (j + 1)) in
    any (max 0 (i - context))
  in
  let shown = Array.init n near in
  let header before after removed added =
    let range start count =
      if count = 1 then string_of_int start
      else Printf.sprintf "%d,%d" (if count = 0 then start - 1 else start) count
    in
    Printf.sprintf "@@ -%s +%s @@\n" (range before removed) (range after added)
  in
  let text = Buffer.create 256 in
  let rec go i before after =
    if i < n then (
      if not shown.(i) then go (i + 1) (before + 1) (after + 1)
      else
        let body = Buffer.create 256 in
        let rec hunk i removed added =
          if i < n && shown.(i) then (
            let sign, line, r, a =
              match all.(i) with
              | Kept line -> (' ', line, 1, 1)
              | Removed line -> ('-', line, 1, 0)
              | Added line -> ('+', line, 0, 1)
            in
            Buffer.add_char body sign;
            Buffer.add_string body line;
            Buffer.add_char body '\n';
            hunk (i + 1) (removed + r) (added + a))
          else (i, removed, added)
        in
        let next, removed, added = hunk i 0 0 in
        Buffer.add_string text (header before after removed added);
        Buffer.add_buffer text body;
        go next (before + removed) (after + added))
  in
  go 0 1 1;
  Buffer.contents text

let unified ~name before after =
  if String.equal before after then ""
  else Printf.sprintf "--- %s\n+++ %s\n%s" name name (hunks (changes (lines before) (lines after)))
