// SPDX-License-Identifier: Apache-2.0
#include "keikan/compare/comparison.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "keikan/compare/report.hpp"
#include "keikan/compare/sequence.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"

using namespace keikan;
using namespace keikan::compare;

namespace {

struct TowerScene {
    Scene scene = read_scene(std::filesystem::path(KEIKAN_SOURCE_DIR) / "data/scenes/tower_closeup.json",
                             ImageSize{80, 80});
    Geometry geometry = build_geometry(scene);
};

const TowerScene& tower() {
    static const TowerScene tower;
    return tower;
}

std::vector<baseline::Method> methods(std::initializer_list<const char*> names) {
    std::vector<baseline::Method> all;
    for (const char* const name : names) all.push_back(baseline::method_of(name));
    return all;
}

}  // namespace

TEST_CASE("compare_methods: kato and catmull are exact, the others err the less the more they look",
          "[compare][truth]") {
    ComparisonOptions options;
    options.methods =
        methods({"kato", "catmull", "none", "multiscan:2", "multiscan:32", "grid:4", "random:64"});
    options.repeat = 2;
    options.search_to = 0;
    const Comparison c = compare_methods(tower().scene, tower().geometry, options);
    REQUIRE(c.methods.size() == 7);
    REQUIRE(c.has_conductors);
    CHECK(c.truth_is == "exact areas in every pixel");
    for (const std::size_t exact : {0u, 1u}) {
        CHECK(c.methods[exact].all.off_share == 0);
        CHECK(c.methods[exact].all.largest < 1e-6);  // a float's rounding of some centroid, at most
    }
    const auto rmse = [&](std::size_t i) { return c.methods[i].conductors.rmse; };
    CHECK(rmse(2) > rmse(3));
    CHECK(rmse(3) > 8 * rmse(4));
    CHECK(rmse(5) > rmse(6));
    for (const MethodResult& method : c.methods) {
        CHECK(method.runs.size() == 2);
        CHECK(method.conductors.pixels == c.conductor_pixel_count);
        CHECK(method.all.pixels == 6400);
    }
    CHECK(c.equal_quality.empty());
}

TEST_CASE("require_exact: one pixel of kato or catmull that is visibly off stops the comparison",
          "[compare][truth]") {
    const auto compared = [](const char* method, double off) {
        ComparisonOptions options;
        options.methods = methods({method});
        options.repeat = 1;
        options.search_to = 0;
        Comparison c = compare_methods(tower().scene, tower().geometry, options);
        Rgb& planted = c.methods[0].picture[{40, 40}];
        planted.g = static_cast<float>(planted.g + (planted.g < 0.5f ? off : -off));
        c.methods[0].all = picture_error(c.methods[0].picture, c.truth);
        return c;
    };
    for (const char* const exact : {"kato", "kato:outline", "catmull"}) {
        CHECK_NOTHROW(require_exact(compared(exact, 0)));
        CHECK_NOTHROW(require_exact(compared(exact, kVisible / 2)));
        CHECK_THROWS_WITH(require_exact(compared(exact, 2 * kVisible)),
                          Catch::Contains(exact) && Catch::Contains("where it must be exact"));
    }
    for (const char* const other : {"kato:paper", "none", "multiscan:4", "grid:4"})
        CHECK_NOTHROW(require_exact(compared(other, 2 * kVisible)));
    Comparison excused = compared("kato", 2 * kVisible);
    excused.water = true;
    CHECK_NOTHROW(require_exact(excused));
    excused.water = false;
    CHECK_THROWS_AS(require_exact(excused), CheckFailure);
    excused.truth_is = "given";
    CHECK_NOTHROW(require_exact(excused));
}

TEST_CASE("compare_methods: the smallest N of equal quality, by doubling and bisection",
          "[compare][search]") {
    ComparisonOptions options;
    options.methods = methods({"kato", "multiscan:4", "random:4"});
    options.repeat = 1;
    options.search_to = 256;
    const Comparison c = compare_methods(tower().scene, tower().geometry, options);
    REQUIRE(c.equal_quality.size() == 4);
    for (const EqualQuality& q : c.equal_quality) {
        // Nothing that looks at places is as good as areas; "nearly all right" is within reach of lines.
        const bool within_reach = q.kind == baseline::Method::Kind::MultiScan && q.goal == Goal::AllRight;
        CHECK(q.reached.has_value() == within_reach);
        if (!within_reach) {
            CHECK(q.last.count == 256);
            continue;
        }
        CHECK(q.reached->conductors.off_share <= kWrongShare);
        for (const Comparison::Trials& trials : c.trials)
            for (const Trial& t : trials.trials)
                if (trials.kind == q.kind && t.count == q.reached->count - 1)
                    CHECK(t.conductors.off_share > kWrongShare);
    }
    REQUIRE(c.trials.size() == 2);
    for (const Comparison::Trials& trials : c.trials)
        for (const Trial& t : trials.trials) {
            const bool samples = trials.kind == baseline::Method::Kind::Random;
            CHECK(t.extrapolated == (samples && t.count > 64));
        }
}

TEST_CASE("compare_methods: samples in conductor pixels alone find the errors of the whole picture there",
          "[compare][search]") {
    ComparisonOptions options;
    options.methods = methods({"kato", "random:256"});  // the whole picture; the search looks at a part of it
    options.repeat = 1;
    options.search_to = 256;
    const Comparison c = compare_methods(tower().scene, tower().geometry, options);
    const Trial& last = c.trials[0].trials.back();
    REQUIRE((last.count == 256 && last.extrapolated));
    CHECK(last.conductors.rmse == c.methods[1].conductors.rmse);
}

TEST_CASE("compare_methods (1): all but the seconds is the same for any number of threads",
          "[compare][threads]") {
    ComparisonOptions options;
    options.methods = methods({"none", "multiscan:3", "random:4"});
    options.repeat = 1;
    std::vector<double> errors[2];
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        for (const MethodResult& r : compare_methods(tower().scene, tower().geometry, options).methods)
            errors[threads - 1].push_back(r.all.rmse);
    }
    CHECK(errors[0] == errors[1]);
}

TEST_CASE("conductor_pixels: where any part of a conductor is seen", "[compare]") {
    Mesh wire, wall;
    const auto rectangle = [](Mesh& mesh, double left, double right, double top, double bottom,
                              double depth) {
        const std::uint32_t corners[] = {
            mesh.add_position({left, depth, -top}), mesh.add_position({right, depth, -top}),
            mesh.add_position({right, depth, -bottom}), mesh.add_position({left, depth, -bottom})};
        mesh.add_face(corners, 0);
    };
    rectangle(wire, 0.5, 3.5, 1.25, 1.26, 9);
    rectangle(wall, 2, 3, 0, 4, 8);  // hides the wire in the third column
    Geometry geometry;
    geometry.objects = {{"wire", ObjectKind::Conductor, wire}, {"wall", ObjectKind::Building, wall}};
    geometry.first_face = {0, 1, 2};
    Camera camera;
    camera.kind = Camera::Kind::Orthographic;
    camera.focal_px = 1;
    camera.centre_x = camera.centre_y = 0;
    camera.size = {4, 4};
    const Image<std::uint8_t> mask = conductor_pixels(geometry, camera);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) CHECK(mask[{x, y}] == (y == 1 && x != 2 ? 1 : 0));
}

TEST_CASE("render_sequence: exact areas change as the truth does, point samples flicker",
          "[compare][flicker]") {
    SequenceOptions options;
    options.methods = methods({"kato", "none", "multiscan:4"});
    options.frames = 4;
    const Sequence sequence = render_sequence(tower().scene, tower().geometry, options);
    REQUIRE(sequence.methods.size() == 3);
    CHECK(sequence.conductors.size() > 10);
    CHECK(sequence.truth.light.size() == 4);
    CHECK(sequence.truth.total > 0);
    CHECK(sequence.methods[0].total == Approx(sequence.truth.total).epsilon(1e-9));
    CHECK(sequence.methods[1].total > 3 * sequence.truth.total);
    CHECK(sequence.methods[2].total > sequence.truth.total);
    CHECK(sequence.methods[2].total < sequence.methods[1].total);
    CHECK(sequence.methods[0].frames[0] != sequence.methods[0].frames[3]);
}

TEST_CASE("comparison_plot and comparison_table: a place for every method", "[compare][report]") {
    ComparisonOptions options;
    options.methods = methods({"kato", "none", "multiscan:2", "multiscan:8"});
    options.repeat = 1;
    options.search_to = 0;
    const Comparison c = compare_methods(tower().scene, tower().geometry, options);
    const std::string table = comparison_table("tower", c, std::nullopt), plot = comparison_plot("tower", c);
    for (const std::string name : {"kato", "none", "multiscan:2", "multiscan:8"})
        CHECK_THAT(table, Catch::Contains("| `" + name + "` |"));
    for (const std::string name : {">kato<", ">none<", ">multiscan:8<"})
        CHECK_THAT(plot, Catch::Contains(name));
    CHECK(std::count(table.begin(), table.end(), '\n') == 2 + 2 + 4);
}
