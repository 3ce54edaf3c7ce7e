A hundred shards, some with one run more than others, in any order and two at a time.

  $ . ./follow.sh && follow 1 45
  $ cat > gaps.toml << 'PLAN'
  > program = "follow.frob"
  > robots = ["pioneer", "scout"]
  > [params]
  > gap = "0.2[m] to 0.4[m], 3 steps"
  > PLAN
  $ frobc sweep gaps.toml --rows whole --table whole.csv > told
  $ seq 100 -1 1 | xargs -P 2 -I K frobc sweep gaps.toml -j 1 --shard K/100 > /dev/null
  $ cat gaps.rows/*.rows | cut -f 1 | sort | uniq -c | awk '{ runs++; made += $1 } END { print runs, made }'
  270 270
  $ frobc sweep gaps.toml --merge > merged && cmp gaps.csv whole.csv && sed s/gaps.csv/whole.csv/ merged | diff - told
