# Runs an example with many seeds of sensor and odometry noise:
#
#   seeds.sh EXAMPLE_FOLDER ROBOT COUNT CHECKS... [-- OPTIONS_OF_FROBC_RUN...]
#
# CHECKS are those of within.sh, for the summary of each run and the values that wandering.awk adds.
# Prints the seeds that fail, and finally their number.
here=$(dirname "$0")
. "$here/within.sh"
example=$1 robot=$2 count=$3
shift 3
checks=
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  checks="$checks $1"
  shift
done
[ $# -eq 0 ] || shift
log=$(mktemp)
trap 'rm -f "$log"' EXIT
one () {
  frobc run "$example/$(basename "$example").frob" --robot "$robot" --seed "$seed" --record "$log" "$@"
  awk -f "$here/wandering.awk" "$log"
}
failed=0
for seed in $(seq 1 "$count"); do
  one "$@" | within $checks || { echo "with seed $seed on $robot"; failed=$((failed + 1)); }
done
echo "$robot: $failed of $count seeds out of bounds"
[ "$failed" -eq 0 ]
