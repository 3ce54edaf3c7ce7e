# For tests that compare tables of sweeps: `follow SECONDS SEEDS` writes follow.frob, a wall
# follower with a trial of this duration and this number of seeds that measures something.
follow () {
    cat > follow.frob << FROB
import Robot
import Trial
import WallFollow
param gap :: Distance = 0.3[m]
main :: (HasSonar i, DiffDrive o) => Program i o
main = reactimateRobot (wallFollow1 gap)
trial "keeps off" = Trial { world = "room.toml", lasts = $1[s], seeds = 1 \`to\` $2, judge = proc t -> neverTouches t where
    error = meanOf (t.clearance - gap)
}
FROB
}
