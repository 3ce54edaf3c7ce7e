let ok = 0
let rejected = 1
let wrong_use = 2
let bug = 3
let fault = 4
