// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../support/scratch_folder.hpp"
#include "keikan/image/exr_file.hpp"
#include "keikan/image/png_file.hpp"
#include "run_keikan.hpp"

namespace {

/// A copy of the smallest scene beside the terrain it names, changed by `change`.
template <typename Change>
std::string changed_hill(const ScratchFolder& folder, const Change& change) {
    nlohmann::json scene = nlohmann::json::parse(contents(hill()));
    change(scene);
    scene["terrain"]["grid"] = KEIKAN_SOURCE_DIR "/data/terrain/hill.png";
    const std::string file = folder / "changed.json";
    std::ofstream(file) << scene;
    return file;
}

}  // namespace

TEST_CASE("keikan render: a picture of the scene's size, or of the size asked for", "[app][render]") {
    const ScratchFolder folder("app");
    const std::string picture = folder / "hill.png";
    const Run run = run_keikan("render " + hill() + " -o " + picture);
    REQUIRE(run.exit_code == 0);
    CHECK(run.out.empty());
    CHECK(run.complains_in_one_line());  // no complaint: it says what it wrote, and draws no bar in a pipe
    CHECK(keikan::read_png(picture).size() == keikan::ImageSize{320, 208});
    const Run quiet = run_keikan("render --quiet " + hill() + " --size 64x40 -o - ");
    CHECK(quiet.err.empty());
    std::ofstream(folder / "out.png", std::ios::binary) << quiet.out;
    CHECK(keikan::read_png(folder / "out.png").size() == keikan::ImageSize{64, 40});
    CHECK(folder.files() == 2);
}

TEST_CASE("keikan scan and shade: the same bytes as render, after a change of colours too", "[app][shade]") {
    const ScratchFolder folder("app");
    const std::string scan = folder / "hill.scan", scene = changed_hill(folder, [](auto&) {});
    for (const std::string extract : {"outline", "paper"}) {
        REQUIRE(run_keikan("scan " + scene + " --extract " + extract + " -o " + scan).exit_code == 0);
        const std::string relit = changed_hill(folder, [](auto& json) {
            json["light"]["sun"] = {{"direction", {1, -1, 0.5}}, {"colour", {1, 0.5, 0.25}}};
            json["haze"]["range_m"] = 900;
            json["materials"]["ground"]["ramp"]["steep"] = {1, 0, 0};
        });
        for (const std::string kind : {"a.png --bits 8", "a.png --bits 16", "a.exr --aov"}) {
            const std::string name = kind.substr(0, 5);
            REQUIRE(
                run_keikan("render " + relit + " --extract " + extract + " -o " + (folder / kind).string())
                    .exit_code == 0);
            const std::string rendered = contents(folder / name);
            REQUIRE(run_keikan("shade " + scan + " " + relit + " -o " + (folder / kind).string()).exit_code ==
                    0);
            CHECK(contents(folder / name) == rendered);
        }
    }
}

TEST_CASE("keikan render and shade: --shadows stands above the scene's own key", "[app][render][shadow]") {
    const ScratchFolder folder("app");
    const auto picture_of = [&](bool key, const std::string& option) {
        const std::string scene = changed_hill(folder, [&](auto& json) {
            json["image"] = {{"width", 160}, {"height", 104}};
            // A wall that is 100 m high, whose shadow's edge lies before the viewer.
            json["objects"] = {{{"type", "building"},
                                {"name", "wall"},
                                {"footprint_m", {{-200, -300}, {-40, -300}, {-40, -295}, {-200, -295}}},
                                {"floor_m", 60},
                                {"height_m", 100},
                                {"roof", "flat"},
                                {"materials", {{"wall", "ground"}}}}};
            json["light"]["sun"] = {{"azimuth_deg", 30}, {"elevation_deg", 35}, {"shadows", key}};
        });
        const Run run = run_keikan("render " + scene + " -o - --quiet" + option);
        REQUIRE(run.exit_code == 0);
        const std::string scan = folder / "hill.scan";
        REQUIRE(run_keikan("scan " + scene + " -o " + scan).exit_code == 0);
        CHECK(run_keikan("shade " + scan + " " + scene + " -o - --quiet" + option).out == run.out);
        return run.out;
    };
    const std::string without = picture_of(false, ""), with = picture_of(true, "");
    CHECK((without != with));
    CHECK((picture_of(true, " --shadows off") == without));
    CHECK((picture_of(false, " --shadows soft") == with));
    const std::string hard = picture_of(false, " --shadows hard");
    CHECK((hard != with));
    CHECK((hard != without));
}

TEST_CASE("keikan: the bytes do not depend on the number of threads", "[app][threads]") {
    const ScratchFolder folder("app");
    std::string scan, picture;
    for (const std::string threads : {"1", "2", "8"}) {
        const std::string scan_file = folder / "hill.scan";
        REQUIRE(run_keikan("scan " + hill() + " -o " + scan_file + " --threads " + threads).exit_code == 0);
        const Run render = run_keikan("render " + hill() + " -o - --quiet --threads " + threads);
        const Run shade =
            run_keikan("shade " + scan_file + " " + hill() + " -o - --quiet --threads " + threads);
        if (scan.empty()) scan = contents(scan_file), picture = render.out;
        CHECK(contents(scan_file) == scan);
        CHECK(render.out == picture);
        CHECK(shade.out == picture);
    }
}

TEST_CASE("keikan shade: a scan of another geometry or camera is refused", "[app][shade]") {
    const ScratchFolder folder("app");
    const std::string scan = folder / "hill.scan";
    REQUIRE(run_keikan("scan " + hill() + " -o " + scan).exit_code == 0);
    const std::string moved =
        changed_hill(folder, [](auto& json) { json["camera"]["height_above_ground_m"] = 3; });
    const Run run = run_keikan("shade " + scan + " " + moved + " -o " + (folder / "a.png").string());
    CHECK(run.exit_code == 2);
    CHECK(run.complains_in_one_line());
    CHECK_THAT(run.err, Catch::Contains(scan));
    CHECK_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST_CASE("keikan shade: a scan that is cut short or damaged is refused", "[app][shade]") {
    const ScratchFolder folder("app");
    const std::string scan = folder / "hill.scan", bad = folder / "bad.scan";
    REQUIRE(run_keikan("scan " + hill() + " -o " + scan).exit_code == 0);
    const std::string whole = contents(scan);
    const auto refused = [&](const std::string& bytes) {
        std::ofstream(bad, std::ios::binary) << bytes;
        const Run run = run_keikan("shade " + bad + " " + hill() + " -o " + (folder / "a.png").string());
        CHECK(run.exit_code == 2);
        CHECK(run.complains_in_one_line());
        CHECK_THAT(run.err, Catch::Contains(bad));
        CHECK_FALSE(std::filesystem::exists(folder / "a.png"));
    };
    for (const std::size_t length : {std::size_t{0}, std::size_t{10}, whole.size() / 2, whole.size() - 1})
        refused(whole.substr(0, length));
    for (const std::size_t at : {std::size_t{0}, std::size_t{20}, whole.size() / 3, whole.size() / 2}) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        refused(damaged);
    }
}

TEST_CASE("keikan render: OpenEXR holds linear colours, and on demand what lies behind them",
          "[app][render]") {
    const ScratchFolder folder("app");
    const std::string file = folder / "hill.exr";
    REQUIRE(run_keikan("render " + hill() + " -o " + file).exit_code == 0);
    const keikan::ExrPicture plain = keikan::read_exr(file);
    CHECK(plain.channels.size() == 3);
    CHECK_THAT(plain.metadata.at("filter"), Catch::Contains("box of one pixel"));
    REQUIRE(run_keikan("render " + hill() + " --aov -o " + file).exit_code == 0);
    const keikan::ExrPicture all = keikan::read_exr(file);
    for (const std::string name : {"R", "G", "B"}) CHECK(all.channels.at(name) == plain.channels.at(name));
    for (const std::string name : {"background", "object_id", "depth", "flags"})
        CHECK(all.channels.contains(name));
}

TEST_CASE("keikan: --stats tells the seconds of each stage and what was counted", "[app][stats]") {
    const ScratchFolder folder("app");
    const std::string stats = folder / "stats.json";
    REQUIRE(run_keikan("render " + hill() + " -o " + (folder / "a.png").string() + " --stats " + stats)
                .exit_code == 0);
    const auto json = nlohmann::json::parse(contents(stats));
    CHECK(json["pixels"] == 320 * 208);
    for (const std::string count : {"flagged_pixels", "polygons", "parts"})
        CHECK(json[count].get<long>() > 0);
    CHECK(json["samples"] == 0);
    for (const std::string stage : {"read", "build", "render", "write", "total"})
        CHECK(json["seconds"][stage].get<double>() >= 0);
    const std::string scan = folder / "a.scan";
    REQUIRE(run_keikan("scan " + hill() + " -o " + scan + " --stats " + stats).exit_code == 0);
    CHECK(nlohmann::json::parse(contents(stats))["command"] == "scan");
    REQUIRE(run_keikan("shade " + scan + " " + hill() + " -o - --stats " + stats).exit_code == 0);
    CHECK(nlohmann::json::parse(contents(stats))["seconds"].contains("shade"));
}

TEST_CASE("keikan info: says what is in a scene", "[app][info]") {
    const Run run = run_keikan("info " + hill());
    CHECK(run.exit_code == 0);
    CHECK(run.out.ends_with('\n'));
    CHECK(run.err.empty());
}
