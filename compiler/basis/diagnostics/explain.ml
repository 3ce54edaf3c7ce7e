let find code = List.assoc_opt code Explain_pages.all
let codes = List.map fst Explain_pages.all
