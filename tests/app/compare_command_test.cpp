// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "../support/scratch_folder.hpp"
#include "keikan/image/png_file.hpp"
#include "run_keikan.hpp"

namespace {

const std::string kSmall = " --size 48x31 --repeat 1 --quiet ";

}  // namespace

TEST_CASE("keikan compare: a table, a summary, a plot and pictures of every method", "[app][compare]") {
    const ScratchFolder folder("app");
    const std::string out = folder / "out";
    const Run run = run_keikan("compare " + hill() + kSmall + "-o " + out +
                               " --methods kato,none,multiscan:2,grid:4 --search-to 16 --frames 2");
    REQUIRE(run.exit_code == 0);
    CHECK(run.err.empty());
    CHECK(run.out == contents(out + "/table.md"));
    const auto json = nlohmann::json::parse(contents(out + "/compare.json"));
    CHECK(json["size"] == nlohmann::json{48, 31});
    CHECK(json["conductor_pixels"] == 0);
    CHECK(json["searched_in"] == "all pixels");
    REQUIRE(json["methods"].size() == 4);
    CHECK(json["methods"][0]["method"] == "kato");
    CHECK(json["methods"][0]["all"]["off_by_more_than_1_512"] == 0);
    CHECK(json["methods"][1]["all"]["rmse"] > json["methods"][2]["all"]["rmse"]);
    CHECK(json["equal_quality"].size() == 4);
    CHECK(json["trials"]["grid"].size() > 0);
    CHECK(json["sequence"]["frames"] == 2);
    for (const std::string name : {"kato", "none", "multiscan-2", "grid-4"}) {
        CHECK(keikan::read_png(out + "/" + name + ".png").size() == keikan::ImageSize{48, 31});
        CHECK(std::filesystem::exists(out + "/" + name + ".error.png"));
    }
    for (const std::string name : {"plot.svg", "inset.png", "frames.png", "truth.png", "truth.exr"})
        CHECK(std::filesystem::exists(out + "/" + name));
}

TEST_CASE("keikan compare: against a picture that is given", "[app][compare]") {
    const ScratchFolder folder("app");
    const std::string out = folder / "out", reference = folder / "reference.exr";
    REQUIRE(
        run_keikan("render " + hill() + " --size 48x31 --quiet --method none -o " + reference).exit_code ==
        0);
    REQUIRE(run_keikan("compare " + hill() + kSmall + "-o " + out +
                       " --methods none,multiscan:3 --reference " + reference)
                .exit_code == 0);
    const auto json = nlohmann::json::parse(contents(out + "/compare.json"));
    CHECK(json["truth"] == "given");
    CHECK(json["methods"][0]["all"]["rmse"] == 0);
    CHECK(json["methods"][1]["all"]["rmse"] > 0);
    const Run wrong =
        run_keikan("compare " + hill() + " --size 50x31 -o " + out + " --reference " + reference);
    CHECK(wrong.exit_code == 2);
    CHECK(wrong.complains_in_one_line());
    CHECK_THAT(wrong.err, Catch::Contains(reference + ": is 48x31, the scene is 50x31"));
}

TEST_CASE("keikan compare: wrong usage is one line and exit code 2, before any work", "[app][compare]") {
    const ScratchFolder folder("app");
    const auto refused = [&](const std::string& arguments, const std::string& part) {
        const Run run = run_keikan("compare " + arguments);
        INFO(arguments << "\n" << run.err);
        CHECK(run.exit_code == 2);
        CHECK(run.complains_in_one_line());
        CHECK_THAT(run.err, Catch::Contains(part));
    };
    const std::string out = " -o " + (folder / "out").string();
    refused(hill(), "--output");
    refused(hill() + out + " --methods magic", "--methods: method 'magic'");
    refused(hill() + out + " --methods kato,multiscan", "method 'multiscan'");
    refused(hill() + out + " --methods none,none", "'none' stands there twice");
    refused(hill() + out + " --methods ''", "names no method");
    refused(hill() + out + " --repeat 0", "repeat");
    refused(hill() + out + " --inset 999,0", "--inset");
    refused(hill() + out + " --reference " + (folder / "missing.exr").string(), "missing.exr");
    refused(hill() + " -o " + (folder / "no/such/folder").string(), "folder");
    refused((folder / "missing.json").string() + out, "missing.json");
    CHECK(folder.files() == 0);
}

TEST_CASE("keikan render: every method makes a picture, and what is none is refused", "[app][render]") {
    const ScratchFolder folder("app");
    const std::string start = "render " + hill() + " --size 40x26 --quiet -o - --method ";
    const std::string exact = run_keikan(start + "kato").out;
    CHECK(run_keikan(start + "catmull").out == exact);
    for (const std::string method :
         {"none", "multiscan:2", "orthogonal:2", "grid:4", "random:4", "kato:paper"}) {
        const Run run = run_keikan(start + method);
        INFO(method);
        CHECK(run.exit_code == 0);
        CHECK_FALSE(run.out.empty());
        CHECK(run.out != exact);
    }
    const std::string stats = folder / "stats.json";
    REQUIRE(run_keikan(start + "grid:4 --stats " + stats).exit_code == 0);
    const auto told = nlohmann::json::parse(contents(stats));
    CHECK(told["samples"] == 40 * 26 * 4);
    CHECK(told["flagged_pixels"] == 0);
    CHECK(told["scanline_pixels"].get<int>() > 100);
    CHECK(told["processor_seconds"]["render"].get<double>() >= 0);
    CHECK(run_keikan(start + "random:4 --seed 2").out != run_keikan(start + "random:4 --seed 3").out);
    for (const std::string wrong : {"multiscan", "grid:0", "random:x", "kato:exact"}) {
        const Run run = run_keikan(start + wrong);
        CHECK(run.exit_code == 2);
        CHECK_THAT(run.err, Catch::Contains("--method: method '" + wrong + "'"));
    }
}
