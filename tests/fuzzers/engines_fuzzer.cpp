// SPDX-License-Identifier: Apache-2.0
//
// Pixel cases through all engines: they must agree with each other within their bounds, areas and background
// add up to 1, and the order of faces and the turn of outlines change nothing.
#include <algorithm>
#include <cmath>
#include <vector>

#include "encoded_case.hpp"
#include "fuzzer.hpp"
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/clip/visible_areas.hpp"

namespace {

using namespace keikan;
using fuzzers::require;

/// Beyond these sizes kVisibleAreaError is not promised (docs/numerics.md, section 6); the engines must
/// end all the same.
constexpr double kLargest = 0x1p40, kSmallest = 0x1p-400;

struct Answer {
    std::vector<double> areas;
    double background = 0;
    friend bool operator==(const Answer&, const Answer&) = default;
};

Answer answer_of(VisibleAreas& engine, const PixelCase& c, std::span<const FaceView> faces) {
    const PixelCoverage seen = engine(c.pixel, faces, c.nearness());
    Answer answer{std::vector<double>(c.polygons.size(), 0), seen.background};
    for (const VisiblePart& part : seen.parts) answer.areas.at(faces[part.face].id) += part.area;
    return answer;
}

bool promised(double v) {
    return v == 0 || (std::abs(v) <= kLargest && std::abs(v) >= kSmallest);
}

bool promised(const PixelCase& c) {
    for (const Ring& ring : c.polygons)
        for (const Point p : ring)
            if (!promised(p.x) || !promised(p.y)) return false;
    if (c.depth)
        for (const DepthPlane& w : *c.depth)
            if (!promised(w.a) || !promised(w.b) || !promised(w.c)) return false;
    return true;
}

void check_alone(const Answer& answer, const char* engine, const PixelCase& c) {
    double sum = answer.background;
    for (const double area : answer.areas) {
        require(area >= 0 && area <= 1, std::string(engine) + ": an area in [0, 1]: " + pixel_case_line(c));
        sum += area;
    }
    require(std::abs(sum - 1) <= 2 * kAreaSumError,  // twice: this sum is rounded itself
            std::string(engine) + ": areas and background add up to 1: " + pixel_case_line(c));
}

void check_together(const Answer& a, const Answer& b, const PixelCase& c) {
    bool agree = std::abs(a.background - b.background) <= 2 * kVisibleAreaError;
    for (std::size_t i = 0; i < a.areas.size(); ++i)
        agree &= std::abs(a.areas[i] - b.areas[i]) <= 2 * kVisibleAreaError;
    require(agree, "splitting and traversal agree: " + pixel_case_line(c));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static VisibleAreas splitting(Engine::Splitting), traversal(Engine::Traversal),
        published(Engine::Published);
    const PixelCase c = fuzzers::decoded_case({data, size});
    std::vector<FaceView> faces = c.faces();
    const Answer split = answer_of(splitting, c, faces);
    const Answer walked = answer_of(traversal, c, faces);
    published(c.pixel, faces, c.nearness());
    if (!promised(c)) return 0;
    check_alone(split, "splitting", c);
    check_alone(walked, "traversal", c);
    check_together(split, walked, c);

    PixelCase turned = c;
    for (Ring& ring : turned.polygons) std::ranges::reverse(ring);
    require(answer_of(splitting, turned, turned.faces()) == split,
            "outlines turned round give the same bits: " + pixel_case_line(c));
    if (!c.depth) return 0;
    std::ranges::reverse(faces);
    require(answer_of(splitting, c, faces) == split,
            "faces in another order give the same bits: " + pixel_case_line(c));
    return 0;
}
