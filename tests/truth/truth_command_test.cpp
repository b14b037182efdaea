// SPDX-License-Identifier: GPL-3.0-or-later
// The program as its users call it.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../support/file_contents.hpp"
#include "../support/scratch_folder.hpp"
#include "keikan/image/exr_file.hpp"

using namespace keikan;

namespace {

const std::string kHill = KEIKAN_SOURCE_DIR "/data/scenes/hill.json";

struct Run {
    int exit_code = -1;
    std::string out;
    std::string err;
};

Run run_truth(const ScratchFolder& folder, const std::string& arguments) {
    const std::string out = folder / "out", err = folder / "err";
    const std::string command = ">" + out + " 2>" + err + " " KEIKAN_VERIFY_PROGRAM " truth " + arguments;
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(err)};
}

void write(const std::string& file, const std::string& text) {
    std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("keikan-verify truth: a scene's coverages; no 16-bit value of the float path is another",
          "[truth][app]") {
    const ScratchFolder folder("truth");
    const Run run =
        run_truth(folder, kHill + " --size 160x104 -o " + (folder / "a.exr").string() + " --quiet");
    REQUIRE(run.exit_code == 0);
    CHECK(run.err.empty());
    const auto summary = nlohmann::json::parse(run.out);
    CHECK(summary["verdict"] == "pass");
    CHECK(summary["pixels"] == 160 * 104);
    CHECK(summary["codes_16_bit"]["compared"].get<int>() >= 160 * 104);
    CHECK(summary["codes_16_bit"]["differing"] == 0);
    CHECK(summary["max_area_error"].get<double>() < 1e-14);
    const ExrPicture picture = read_exr(folder / "a.exr");
    REQUIRE(picture.channels.contains("coverage.terrain"));
    CHECK(picture.metadata.at("filter").find("box of one pixel") == 0);
    CHECK(picture.metadata.at("window") == "0,0,160,104");
    CHECK(picture.metadata.at("scene_hash").size() == 16);
    const auto& terrain = picture.channels.at("coverage.terrain");
    const auto& sky = picture.channels.at("background");
    bool partly = false;
    for (std::size_t i = 0; i < sky.values().size(); ++i) {
        REQUIRE(double{terrain.values()[i]} + sky.values()[i] == Approx(1).margin(0x1p-24));
        partly = partly || (sky.values()[i] > 0 && sky.values()[i] < 1);
    }
    CHECK(partly);
}

TEST_CASE("keikan-verify truth: the same bytes for any number of threads", "[truth][app]") {
    const ScratchFolder folder("truth");
    for (const std::string threads : {"1", "3"})
        REQUIRE(run_truth(folder, kHill + " --size 80x52 --format cryptomatte --quiet --threads " + threads +
                                      " -o " + (folder / (threads + ".exr")).string())
                    .exit_code == 0);
    CHECK(contents(folder / "1.exr") == contents(folder / "3.exr"));
}

TEST_CASE("keikan-verify truth: layers of polygons, nearest first", "[truth][app][layers]") {
    const ScratchFolder folder("truth");
    write(folder / "frame.wkt", "POLYGON ((1 1, 9 1, 9 9, 1 9, 1 1), (3 3, 3 7, 7 7, 7 3, 3 3))");
    write(folder / "two.geojson",
          R"({"type": "MultiPolygon", "coordinates": [[[[0, 0], [10, 0], [10, 5], [0, 5], [0, 0]]],
              [[[11, 0], [12, 0], [12, 10], [11, 10], [11, 0]]]]})");
    const std::string layers =
        "--layers " + (folder / "frame.wkt").string() + "," + (folder / "two.geojson").string();
    const Run run =
        run_truth(folder, layers + " --window 0,10,12,0 --size 24x20 -o " + (folder / "a.exr").string());
    REQUIRE(run.exit_code == 0);
    const auto summary = nlohmann::json::parse(run.out);
    CHECK(summary["layers"][0]["covered_pixels"] == 4 * (64 - 16));
    CHECK(summary["layers"][1]["covered_pixels"] == 4 * (50 - (8 * 4 - 4 * 2) + 10));
    const ExrPicture picture = read_exr(folder / "a.exr");
    CHECK(picture.channels.at("coverage.frame")[{2, 2}] == 1);  // y from 9 to 8.5
    CHECK(picture.channels.at("coverage.two")[{10, 10}] == 1);  // through the frame's hole
    CHECK(picture.channels.at("background")[{20, 0}] == 1);
    CHECK(picture.metadata.at("window") == "0,10,12,0");
}

TEST_CASE("keikan-verify truth: what it cannot do it says in one line, and writes nothing", "[truth][app]") {
    const ScratchFolder folder("truth");
    write(folder / "bad.wkt", "POLYGON ((0 0, 1 0, 1 1))");
    write(folder / "good.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 0))");
    const std::string bad = folder / "bad.wkt", good = folder / "good.wkt";
    const auto refused = [&](const std::string& arguments, const std::string& word) {
        const Run run = run_truth(folder, arguments);
        CAPTURE(arguments, run.err);
        CHECK(run.exit_code == 2);
        CHECK(run.out.empty());
        CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
        CHECK_THAT(run.err, Catch::StartsWith("keikan-verify: ") && Catch::Contains(word));
    };
    const std::string exr = " -o " + (folder / "a.exr").string();
    refused(kHill + " -o " + (folder / "a.png").string(), ".exr");
    refused(kHill + exr + " --size 0x10", "--size");
    refused(kHill + exr + " --format tiff", "--format");
    refused(kHill + " -o " + (folder / "missing/a.exr").string(), "a.exr");
    refused((folder / "missing.json").string() + exr, "missing.json");
    refused(exr, "--layers");
    refused("--layers " + bad + " --window 0,0,1,1 --size 2x2" + exr, "bad.wkt");
    refused("--layers " + good + " --window 0,0,1 --size 2x2" + exr, "--window");
    refused("--layers " + good + " --window 0,0,0,1 --size 2x2" + exr, "no area");
    refused("--layers " + good + " --window 0,0,1,1" + exr, "--size");
    refused("--layers " + good + ".txt --window 0,0,1,1 --size 2x2" + exr, "good.wkt.txt");
    write(folder / "needle.wkt", "POLYGON ((0 0.5, 1 -0.125, -6.7e-229 -1.8e165, 0 0.5))");
    refused("--layers " + (folder / "needle.wkt").string() + " --window 0,0,1,1 --size 2x2" + exr,
            "undecided");
    CHECK_FALSE(std::filesystem::exists(folder / "a.exr"));
}
