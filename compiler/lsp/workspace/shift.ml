type t = { before : int; behind : int;  (** equal bytes at both ends *) from : int; to_ : int }

let between a b =
  let n = String.length a and m = String.length b in
  let shorter = min n m in
  let rec prefix i = if i < shorter && a.[i] = b.[i] then prefix (i + 1) else i in
  let before = if a == b then n else prefix 0 in
  let rec suffix i =
    if i < shorter - before && a.[n - 1 - i] = b.[m - 1 - i] then suffix (i + 1) else i
  in
  { before; behind = (if a == b then 0 else suffix 0); from = n; to_ = m }

let offset t i =
  if i <= t.before then Some i
  else if i >= t.from - t.behind then Some (i + t.to_ - t.from)
  else None

let range t (start, stop) =
  match (offset t start, offset t stop) with
  | Some start, Some stop when start <= stop -> Some (start, stop)
  | _ -> None
