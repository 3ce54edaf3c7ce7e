let is_name = function
  | "switch" | "dSwitch" | "rSwitch" | "drSwitch" | "resetOn" | "initially" | "onEvent"
  | "sampleEvery" | "mkTask" | "runTask" | "return" | "snapT" | "mapT" | "mapOutput"
  | "constT" | "sleepT" | "forever" | "timeOut" | "abortWhen" | "withSF" | "both" | "race"
  | "thenSF" | "repeatT" | "forEachT" | "retryT" | "whenT" | "unlessT" | "reactimateTask"
  ->
      true
  | _ -> false

let is_type = function "Task" -> true | _ -> false
