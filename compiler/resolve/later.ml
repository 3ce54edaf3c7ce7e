let is_name = function "reactimateTask" -> true | _ -> false
