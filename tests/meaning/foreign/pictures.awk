# Pictures of a bright square that wanders, for the tracker: the header, then one row for
# each instant. At some instants it hides; then it jumps, and moves on faster.
BEGIN {
    printf "time"
    for (i = 0; i < 96; i++) printf ",in[%d]", i
    print ""
    for (t = 0; t < 12; t++) {
        column = t < 8 ? t : 3 * (t - 8); row = t < 8 ? t % 5 : 5
        hidden = t == 5 || t == 6
        printf "%.1f", t / 10
        for (i = 0; i < 96; i++) {
            c = i % 12; r = int(i / 12)
            printf ",%d", (!hidden && c >= column && c <= column + 1 && r >= row && r <= row + 1) ? 200 : (i * 7) % 100
        }
        print ""
    }
}
