// SPDX-License-Identifier: Apache-2.0
#include "visible_stretches.hpp"

#include <algorithm>

namespace keikan::baseline {

/// Whether i is seen rather than j from t on.
bool VisibleStretches::nearer(std::size_t i, std::size_t j, double t) const {
    const double wi = w(i, t), wj = w(j, t);
    if (wi != wj) return wi > wj;
    const Crossed &p = crossed_[i], &q = crossed_[j];
    return p.slope != q.slope ? p.slope > q.slope : p.face < q.face;
}

void VisibleStretches::emit(double from, double to) {
    if (seen_ == kNone || !(from < to)) return;
    const std::uint32_t face = crossed_[seen_].face;
    if (!stretches_.empty() && stretches_.back().face == face && stretches_.back().end == from)
        stretches_.back().end = to;
    else
        stretches_.push_back({from, to, face});
}

/// Finds who first overtakes the face that is seen. Only a face whose w rises faster can; one that rounding
/// shows as nearer already overtakes at once, and since slopes rise with each change there, changes end.
void VisibleStretches::look_for_overtaker(double t) {
    overtaker_ = kNone;
    if (seen_ == kNone) return;
    overtaken_at_ = crossed_[seen_].end;
    const double w_seen = w(seen_, t), slope_seen = crossed_[seen_].slope;
    for (std::size_t k = 0; k < live_.size();) {
        const Crossed& other = crossed_[live_[k]];
        if (other.end <= t) {
            live_[k] = live_.back();
            live_.pop_back();
            continue;
        }
        if (other.slope > slope_seen) {
            const double at = t + std::max(w_seen - w(live_[k], t), 0.0) / (other.slope - slope_seen);
            if (at < other.end && at < overtaken_at_) {
                overtaken_at_ = at;
                overtaker_ = live_[k];
            }
        }
        ++k;
    }
}

void VisibleStretches::see(std::size_t i, double t) {
    seen_ = i;
    look_for_overtaker(t);
}

void VisibleStretches::see_best(double t) {
    std::size_t best = kNone;
    for (const std::size_t i : live_)
        if (crossed_[i].end > t && (best == kNone || nearer(i, best, t))) best = i;
    if (best == kNone) live_.clear();
    see(best, t);
}

std::span<const Stretch> VisibleStretches::operator()(std::span<const Crossed> crossed, double length) {
    crossed_ = crossed;
    stretches_.clear();
    live_.clear();
    seen_ = overtaker_ = kNone;
    double t = 0;
    for (std::size_t next = 0;;) {
        double until = length;
        if (seen_ != kNone)
            until = std::min(until, overtaker_ != kNone ? overtaken_at_ : crossed_[seen_].end);
        // Who begins where the seen face ends is taken in first: otherwise what lies behind both would be
        // looked for in vain.
        if (next < crossed.size() && crossed[next].begin <= until && crossed[next].begin < length) {
            const std::size_t i = next++;
            if (crossed[i].end <= t) continue;
            const double begin = std::max(crossed[i].begin, t);
            emit(t, begin);
            t = begin;
            live_.push_back(i);
            if (seen_ != kNone && crossed[seen_].end <= t) {
                see_best(t);
            } else if (seen_ == kNone || nearer(i, seen_, t)) {
                see(i, t);
            } else if (crossed[i].slope > crossed[seen_].slope) {
                const double at = t + (w(seen_, t) - w(i, t)) / (crossed[i].slope - crossed[seen_].slope);
                if (at < crossed[i].end && at < until) overtaker_ = i, overtaken_at_ = at;
            }
            continue;
        }
        emit(t, until);
        t = until;
        if (t >= length) return stretches_;
        if (seen_ == kNone) return stretches_;
        if (overtaker_ != kNone)
            see(overtaker_, t);
        else
            see_best(t);
    }
}

}  // namespace keikan::baseline
