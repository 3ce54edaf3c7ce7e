It wanders through a cluttered hall for five minutes and never stays within half a
metre of a place for a minute. `make seeds` does the same with a hundred seeds.

  $ for robot in pioneer scout create; do
  >   sh seeds.sh ../../../examples/explore $robot 3 longest_stay 0 60 squares 15 70 -- --for 5min
  > done
  pioneer: 0 of 3 seeds out of bounds
  scout: 0 of 3 seeds out of bounds
  create: 0 of 3 seeds out of bounds
