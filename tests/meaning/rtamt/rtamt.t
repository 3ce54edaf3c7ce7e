Conditions on the past, nested at random, are what RTAMT 0.4.10 says of them, which monitors
signal temporal logic (`agree.py --store`; `make rtamt` compares a thousand anew).

  $ frobc trace stored.frob --input stored.csv --engine interp | diff stored.expected -
  $ frobc trace stored.frob --input stored.csv | diff stored.expected -
