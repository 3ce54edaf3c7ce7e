let f = Printf.sprintf

let condition (signals : Scope.t) =
  let condition () = Expression.expression signals 2 Bool in
  let p = condition () in
  match Random.State.int signals.random 9 with
  | 0 -> f "(respondsWithin 0.3[s] (%s, %s))" p (condition ())
  | 1 -> f "(afterwards (%s, %s))" p (condition ())
  | 2 -> f "(max (verdict %s) (by 0.5[s] %s))" p (condition ())
  | 3 -> f "(implies %s %s)" p (condition ())
  | 4 -> f "(heldFor 0.2[s] %s)" p
  | 5 -> f "(within 0.2[s] (always %s))" p
  | 6 -> f "(since (%s, %s))" p (condition ())
  | 7 -> f "(holds (verdict (ever %s)))" p
  | _ -> f "(%s)" p
