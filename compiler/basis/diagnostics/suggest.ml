(* Restricted Damerau-Levenshtein distance, computed row by row. Returns [None] as soon as the
   distance is certain to exceed [limit]. *)
let distance ~limit a b =
  let n = String.length a and m = String.length b in
  if abs (n - m) > limit then None
  else
    let rec rows i before previous =
      if i > n then Some previous.(m)
      else
        let row = Array.make (m + 1) i in
        for j = 1 to m do
          let replaced = if Char.equal a.[i - 1] b.[j - 1] then 0 else 1 in
          let best = min (previous.(j - 1) + replaced) (min previous.(j) row.(j - 1) + 1) in
          let swapped =
            i > 1 && j > 1 && Char.equal a.[i - 1] b.[j - 2] && Char.equal a.[i - 2] b.[j - 1]
          in
          row.(j) <- (if swapped then min best (before.(j - 2) + 1) else best)
        done;
        if Array.exists (fun d -> d <= limit) row || Array.exists (fun d -> d < limit) previous then
          rows (i + 1) previous row
        else None
    in
    match rows 1 [||] (Array.init (m + 1) Fun.id) with
    | Some d when d <= limit -> Some d
    | Some _ | None -> None

(* The words of a name, in lower case and sorted alphabetically: [follow] and [wall] for
   [wallFollow]. *)
let words name =
  let rec split i start found =
    let add () = if i > start then String.sub name start (i - start) :: found else found in
    if i >= String.length name then add ()
    else if name.[i] = '_' then split (i + 1) (i + 1) (add ())
    else if Character.is_upper name.[i] then split (i + 1) i (add ())
    else split (i + 1) start found
  in
  List.sort String.compare (List.map String.lowercase_ascii (split 0 0 []))

(* The only candidate that consists of the same words in another order. *)
let reordered name candidates =
  match words name with
  | _ :: _ :: _ as all -> (
      match List.filter (fun candidate -> words candidate = all) candidates with
      | [ candidate ] -> Some candidate
      | _ -> None)
  | _ -> None

let closest name candidates =
  let limit = min 3 ((String.length name + 1) / 3) in
  let lower = String.lowercase_ascii name in
  let rank candidate =
    if String.equal candidate name then None
    else if String.equal (String.lowercase_ascii candidate) lower then Some 0
    else if limit = 0 then None
    else distance ~limit name candidate
  in
  let better best candidate =
    match (rank candidate, best) with
    | None, _ -> best
    | Some d, Some (d', other) when (d', other) <= (d, candidate) -> best
    | Some d, (Some _ | None) -> Some (d, candidate)
  in
  match List.fold_left better None candidates with
  | Some (_, candidate) -> Some candidate
  | None -> reordered name candidates
