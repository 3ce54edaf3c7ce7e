type step = {
  before : int;  (** number of equal bytes at the start *)
  behind : int;  (** number of equal bytes at the end *)
  from : int;
  to_ : int;
}

type t = step list

let none = []

let between a b =
  if String.equal a b then none
  else
    let n = String.length a and m = String.length b in
    let shorter = min n m in
    let rec prefix i = if i < shorter && a.[i] = b.[i] then prefix (i + 1) else i in
    let before = prefix 0 in
    let rec suffix i =
      if i < shorter - before && a.[n - 1 - i] = b.[m - 1 - i] then suffix (i + 1) else i
    in
    [ { before; behind = suffix 0; from = n; to_ = m } ]

let and_then first second = first @ second
let back t = List.rev_map (fun s -> { s with from = s.to_; to_ = s.from }) t

let step i s =
  if i <= s.before then Some i
  else if i >= s.from - s.behind then Some (i + s.to_ - s.from)
  else None

let offset t i = List.fold_left (fun i s -> Option.bind i (fun i -> step i s)) (Some i) t

let place t range =
  let step (start, stop) s =
    if stop <= s.before then Some (start, stop)
    else if start >= s.from - s.behind then Some (start + s.to_ - s.from, stop + s.to_ - s.from)
    else None
  in
  List.fold_left (fun range s -> Option.bind range (fun range -> step range s)) (Some range) t

let range t (start, stop) =
  match (offset t start, offset t stop) with
  | Some start, Some stop when start <= stop -> Some (start, stop)
  | _ -> None
