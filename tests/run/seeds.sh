# Runs an example with many seeds of sensor and odometry noise:
#
#   seeds.sh EXAMPLE_FOLDER ROBOT COUNT CHECKS... [-- OPTIONS_OF_FROBC_RUN...]
#
# CHECKS are those of within.sh, for each run. Says which seeds fail them, and in
# the end how many did.
. "$(dirname "$0")/within.sh"
example=$1 robot=$2 count=$3
shift 3
checks=
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  checks="$checks $1"
  shift
done
[ $# -eq 0 ] || shift
failed=0
for seed in $(seq 1 "$count"); do
  frobc run "$example/$(basename "$example").frob" --robot "$robot" --seed "$seed" "$@" |
    within $checks || { echo "with seed $seed on $robot"; failed=$((failed + 1)); }
done
echo "$robot: $failed of $count seeds out of bounds"
[ "$failed" -eq 0 ]
