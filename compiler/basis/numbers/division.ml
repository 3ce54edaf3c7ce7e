let div a b =
  if Int32.equal b 0l then 0l
  else
    let quotient = Int32.div a b and rest = Int32.rem a b in
    if (not (Int32.equal rest 0l)) && Int32.compare rest 0l < 0 <> (Int32.compare b 0l < 0) then
      Int32.pred quotient
    else quotient

let mod_ a b = if Int32.equal b 0l then 0l else Int32.sub a (Int32.mul (div a b) b)
