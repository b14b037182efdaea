// SPDX-License-Identifier: GPL-3.0-or-later
// Planted faults: faces that the projection leaves out although they can be seen.
#include "crosscheck/left_out_check.hpp"

#include <catch2/catch.hpp>

#include "../scan/small_scenes.hpp"
#include "small_picture.hpp"

using namespace keikan;
using namespace keikan::crosscheck;

namespace {

/// `faces` without one of them.
ProjectedFaces without(const ProjectedFaces& faces, FaceId left_out) {
    ProjectedFaces rest;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (faces.id[i] == left_out) continue;
        const auto outline = faces[i].outline;
        rest.points.insert(rest.points.end(), outline.begin(), outline.end());
        rest.begin.push_back(static_cast<std::uint32_t>(rest.points.size()));
        rest.id.push_back(faces.id[i]);
        rest.plane.push_back(faces.plane[i]);
    }
    return rest;
}

CheckSummary found_without(FaceId left_out, std::uint64_t one_in = 1) {
    const SmallPicture picture;
    CheckSummary summary;
    check_left_out(without(picture.faces, left_out), picture.faces, SmallPicture::kSize, 1, one_in, summary);
    REQUIRE(summary.left_out.has_value());
    CHECK(summary.left_out->faces == 1);
    return summary;
}

}  // namespace

TEST_CASE("left_out_check: a face that is hidden everywhere may be left out", "[crosscheck][left-out]") {
    const CheckSummary summary = found_without(SmallPicture::Hidden);
    CHECK(summary.pass());
    CHECK(summary.left_out->pixels == 4);  // its bounding box
    CHECK(summary.left_out->largest == 0);
}

TEST_CASE("left_out_check: a wire that is left out is found in every pixel that it crosses",
          "[crosscheck][left-out][planted]") {
    const CheckSummary summary = found_without(SmallPicture::Wire);
    CHECK(summary.left_out->pixels == SmallPicture::kSize.width);
    REQUIRE(summary.disagreement_count == SmallPicture::kSize.width);
    for (const Disagreement& d : summary.disagreements) {
        CHECK(d.kind == Disagreement::Kind::LeftOut);
        CHECK(d.pixel.y == 0);
        CHECK(d.face == SmallPicture::Wire);
        CHECK(d.error == Approx(0.0625).epsilon(1e-12));  // a sixteenth of a pixel thick
    }
    CHECK(summary.left_out->largest == Approx(0.0625).epsilon(1e-12));
    CHECK_FALSE(summary.pass());
}

TEST_CASE("left_out_check: an open mesh that says that it is closed is found out",
          "[crosscheck][left-out][planted]") {
    const Camera view = small_scenes::camera({4, 4});
    Mesh back;
    small_scenes::add_rectangle(back, view, 1, 1, 3, 3, 10);  // its back is towards the camera
    back.closed = true;
    const Geometry geometry = small_scenes::geometry(back);
    const ProjectedFaces asked = project_faces(geometry, view),
                         all = project_faces(geometry, view, HiddenBacks::Kept);
    CHECK(asked.size() == 0);
    REQUIRE(all.size() == 1);
    CheckSummary summary;
    check_left_out(asked, all, view.size, 1, 1, summary);
    CHECK(summary.disagreement_count == 4);

    const CheckSummary clean = [&] {
        CheckSummary nothing;
        check_left_out(all, all, view.size, 1, 1, nothing);
        return nothing;
    }();
    CHECK(clean.pass());
    CHECK(clean.left_out->faces == 0);
}
