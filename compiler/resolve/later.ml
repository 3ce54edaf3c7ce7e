let is_name = function
  | "!" | "switch" | "dSwitch" | "rSwitch" | "drSwitch" | "resetOn" | "initially" | "onEvent"
  | "sampleEvery" | "mapSF" | "mkTask" | "runTask" | "return" | "snapT" | "mapT" | "mapOutput"
  | "constT" | "sleepT" | "forever" | "timeOut" | "abortWhen" | "withSF" | "both" | "race"
  | "thenSF" | "repeatT" | "forEachT" | "retryT" | "whenT" | "unlessT" | "reactimateTask"
  | "length" | "at" | "generate" | "map" | "imap" | "zipWith" | "foldl" | "scanl" | "minimumBy"
  | "maximumBy" | "any" | "all" | "replace" ->
      true
  | _ -> false

let is_type = function "Task" | "Array" -> true | _ -> false
