// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "../support/file_contents.hpp"
#include "../support/scratch_folder.hpp"

namespace {

/// `keikan-verify convert` in `folder`; its complaint is left in the file err.
int convert(const ScratchFolder& folder, const std::string& arguments) {
    const std::string command =
        "cd " + folder.path.string() + " && " KEIKAN_VERIFY_PROGRAM " convert " + arguments + " 2>err";
    return WEXITSTATUS(std::system(command.c_str()));
}

void refused(const ScratchFolder& folder, const std::string& arguments, const std::string& complaint) {
    const long files = folder.files();
    INFO(arguments);
    CHECK(convert(folder, arguments) == 2);
    CHECK(contents(folder / "err") == "keikan-verify: " + complaint + "\n");
    CHECK(folder.files() == files);
}

}  // namespace

TEST_CASE("keikan-verify convert: round through every format, the same bytes come back", "[convert]") {
    const ScratchFolder folder("convert");
    std::ofstream all(folder / "all.jsonl");
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(KEIKAN_SOURCE_DIR "/data/degenerate"))
        if (entry.path().extension() == ".jsonl") all << contents(entry.path());
    all.close();
    REQUIRE(convert(folder, "all.jsonl plain.jsonl") == 0);
    CHECK(convert(folder, "plain.jsonl a.wkt") == 0);
    CHECK(convert(folder, "a.wkt b.geojson") == 0);
    CHECK(convert(folder, "- - --from geojson --to jsonl <b.geojson >again.jsonl") == 0);
    CHECK(contents(folder / "again.jsonl") == contents(folder / "plain.jsonl"));
    CHECK(convert(folder, "b.geojson drawing.svg") == 0);
    const std::string drawing = contents(folder / "drawing.svg");
    CHECK(drawing.starts_with("<svg"));
    CHECK(drawing.find("exactly-the-pixel") != drawing.npos);
}

TEST_CASE("keikan-verify convert: bad input is exit code 2, its place and reason, and nothing written",
          "[convert][errors]") {
    const ScratchFolder folder("convert");
    std::ofstream(folder / "err");
    std::ofstream(folder / "good.wkt") << "POLYGON ((0 0, 1 0, 0 1, 0 0))\n";
    std::ofstream(folder / "bad.wkt") << "POLYGON ((0 0, 1 0, 0 1, 0 0))\nPOLYGON ((0 0, 1 0 7))\n";
    std::ofstream(folder / "concave.jsonl") << R"({"polygons": [[[0, 0], [2, 0], [2, 2], [1, 0.5]]]})";
    std::ofstream(folder / "old.jsonl") << "old\n";
    refused(folder, "bad.wkt new.jsonl", "bad.wkt:2:20: expected ',' or ')'");
    refused(folder, "bad.wkt old.jsonl", "bad.wkt:2:20: expected ',' or ')'");
    refused(folder, "concave.jsonl new.geojson", "concave.jsonl:1: polygons[0] is not convex");
    refused(folder, "good.wkt new.txt",
            "new.txt: has none of the endings .jsonl, .wkt, .geojson, .svg: use --to");
    refused(folder, "good.wkt new.jsonl --to png", "--to png: there are only: jsonl, wkt, geojson, svg");
    refused(folder, "picture.svg new.jsonl", "picture.svg: is a drawing, which cannot be read back");
    refused(folder, "missing.wkt new.jsonl", "missing.wkt: cannot be opened");
    CHECK(contents(folder / "old.jsonl") == "old\n");
    // Standard output, too, gets nothing of a file that is bad at its end.
    std::ofstream(folder / "out");
    refused(folder, "bad.wkt - --to jsonl >out", "bad.wkt:2:20: expected ',' or ')'");
    CHECK(contents(folder / "out").empty());
}
