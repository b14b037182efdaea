// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <polyclipping/clipper.hpp>
#include <stdexcept>

#include "peers/repeated_differences.hpp"

namespace keikan::peers {
namespace {

/// Whole numbers up to 2^62 are allowed; 2^60 for the pixel's side is the finest power of two that leaves
/// room for the library's own sums. Every double in the pixel down to 2^-8 is kept exactly.
constexpr double kScale = 0x1p60;

class Clipper {
  public:
    void operator()(const PreparedPixel& pixel, Answer& answer) {
        answer.areas.assign(pixel.in_pixel.size(), 0.0);
        nearer_.clear();
        for (std::size_t i = 0; i < pixel.in_pixel.size(); ++i) {
            if (pixel.in_pixel[i].empty()) continue;
            ClipperLib::Path path = scaled(pixel.in_pixel[i]);
            answer.areas[i] = visible_area(path);
            nearer_.push_back(std::move(path));
        }
        set_background(answer);
    }

  private:
    static ClipperLib::Path scaled(const Ring& ring) {
        ClipperLib::Path path;
        path.reserve(ring.size());
        for (const Point p : ring) path.emplace_back(std::llround(p.x * kScale), std::llround(p.y * kScale));
        return path;
    }

    double visible_area(const ClipperLib::Path& path) {
        clipper_.Clear();
        if (!clipper_.AddPath(path, ClipperLib::ptSubject, true)) return 0;  // no area on the grid
        clipper_.AddPaths(nearer_, ClipperLib::ptClip, true);
        if (!clipper_.Execute(ClipperLib::ctDifference, rest_, ClipperLib::pftNonZero,
                              ClipperLib::pftNonZero))
            throw std::runtime_error("Execute returned false");
        double area = 0;
        for (const ClipperLib::Path& part : rest_) area += ClipperLib::Area(part);  // holes are negative
        return area / (kScale * kScale);
    }

    ClipperLib::Clipper clipper_;
    ClipperLib::Paths nearer_;
    ClipperLib::Paths rest_;
};

}  // namespace

Peer clipper() {
    return {.name = "clipper", .version = "Clipper " CLIPPER_VERSION, .start = []() -> Ask {
                return [library = std::make_shared<Clipper>()](const PreparedPixel& pixel, Answer& answer) {
                    (*library)(pixel, answer);
                };
            }};
}

}  // namespace keikan::peers
