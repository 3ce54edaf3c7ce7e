#include "rolling.h"

namespace frob::sim {

Rolling::Rolling(const Ball &ball) : corners_(ball.way), speed_(ball.speed) {
    if (!ball.closed)
        for (std::size_t i = ball.way.size(); i-- > 2;) corners_.push_back(ball.way[i - 1]);
}

void Rolling::advance(double dt_s) {
    if (corners_.size() < 2) return;
    gone_ += speed_ * dt_s;
    for (;;) {
        const std::size_t next = (behind_ + 1) % corners_.size();
        const double piece = length(corners_[next] - corners_[behind_]);
        if (gone_ < piece) return;
        gone_ -= piece;
        behind_ = next;
    }
}

Vec Rolling::place() const {
    const Vec from = corners_[behind_];
    if (gone_ <= 0.0) return from;
    const Vec way = corners_[(behind_ + 1) % corners_.size()] - from;
    return from + (gone_ / length(way)) * way;
}

} // namespace frob::sim
