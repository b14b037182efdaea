// SPDX-License-Identifier: Apache-2.0
#include "scanline_lengths.hpp"

#include <algorithm>
#include <limits>

namespace keikan {
namespace {

/// Where the line y = `row` enters and leaves a convex outline.
struct Crossings {
    double begin = std::numeric_limits<double>::infinity();
    double end = -std::numeric_limits<double>::infinity();
};

Crossings crossings(std::span<const Point> outline, double row) {
    Crossings found;
    const auto met = [&](double x) {
        found.begin = std::min(found.begin, x);
        found.end = std::max(found.end, x);
    };
    for (std::size_t k = 0; k < outline.size(); ++k) {
        Point p = outline[k], q = outline[k + 1 < outline.size() ? k + 1 : 0];
        if (p.y > q.y) std::swap(p, q);  // both faces at an edge get the same crossing
        if (p.y == row) met(p.x);
        if (q.y == row) met(q.x);
        if (p.y < row && row < q.y) met(p.x + (row - p.y) / (q.y - p.y) * (q.x - p.x));
    }
    return found;
}

}  // namespace

/// Adds a face: in front of what is seen, behind it, or crossing through it. Equal nearness leaves what is
/// there, which has the smaller id.
void ScanlineLengths::put(const Stretch& face) {
    next_.clear();
    const auto emit = [&](Stretch of, double begin, double end) {
        if (!(begin < end)) return;
        if (!next_.empty() && next_.back().face == of.face && next_.back().end == begin) {
            next_.back().end = end;
            return;
        }
        of.begin = begin;
        of.end = end;
        next_.push_back(of);
    };
    double free_from = face.begin;  // what is left of the face lies right of this
    for (const Stretch& old : seen_) {
        emit(face, std::min(free_from, old.begin), std::min(old.begin, face.end));
        const double begin = std::max(old.begin, face.begin);
        const double end = std::min(old.end, face.end);
        if (!(begin < end)) {
            emit(old, old.begin, old.end);
        } else {
            emit(old, old.begin, begin);
            // The face is nearer where slope x + start > 0; coefficients are subtracted first.
            const double slope = face.slope - old.slope;
            const double start = face.start - old.start;
            const double at_begin = slope * begin + start;
            const double at_end = slope * end + start;
            if (at_begin <= 0 && at_end <= 0) {
                emit(old, begin, end);
            } else if (at_begin >= 0 && at_end >= 0) {
                emit(face, begin, end);
            } else {
                const double meet = std::clamp(-start / slope, begin, end);
                emit(at_begin > 0 ? face : old, begin, meet);
                emit(at_begin > 0 ? old : face, meet, end);
            }
            emit(old, end, old.end);
        }
        free_from = std::max(free_from, old.end);
    }
    emit(face, free_from, face.end);
    std::swap(seen_, next_);
}

std::span<const SeenPart> ScanlineLengths::operator()(PixelIndex pixel, std::span<const FaceView> faces) {
    seen_.clear();
    const double row = pixel.y + 0.5;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
        const Crossings line = crossings(faces[f].outline, row);
        Stretch stretch;
        stretch.begin = std::max(line.begin - pixel.x, 0.0);
        stretch.end = std::min(line.end - pixel.x, 1.0);
        stretch.slope = faces[f].depth.a;
        stretch.start = faces[f].depth.a * pixel.x + faces[f].depth.b * row + faces[f].depth.c;
        stretch.face = f;
        if (stretch.begin < stretch.end) put(stretch);
    }

    // A face that is seen in several stretches is one part, at their common centroid.
    parts_.clear();
    background_ = 0;
    double covered_to = 0;
    for (const Stretch& s : seen_) {
        background_ += s.begin - covered_to;
        covered_to = s.end;
    }
    background_ += 1 - covered_to;
    std::stable_sort(seen_.begin(), seen_.end(),
                     [](const Stretch& s, const Stretch& t) { return s.face < t.face; });
    for (std::size_t i = 0; i < seen_.size();) {
        const std::uint32_t face = seen_[i].face;
        double length = 0, moment = 0;
        for (; i < seen_.size() && seen_[i].face == face; ++i) {
            length += seen_[i].end - seen_[i].begin;
            moment += (seen_[i].end - seen_[i].begin) * (seen_[i].begin + seen_[i].end) / 2;
        }
        parts_.push_back(
            {face, static_cast<float>(std::clamp(moment / length, 0.0, 1.0)), 0.5f, std::min(length, 1.0)});
    }
    return parts_;
}

}  // namespace keikan
