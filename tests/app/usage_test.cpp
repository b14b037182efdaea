// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "../support/scratch_folder.hpp"
#include "run_keikan.hpp"

namespace {

void refused(const std::string& arguments, const std::string& part) {
    const Run run = run_keikan(arguments);
    INFO(arguments << "\n" << run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.complains_in_one_line());
    CHECK_THAT(run.err, Catch::Contains(part));
    CHECK(run.out.empty());
}

}  // namespace

TEST_CASE("keikan: --help and --version answer on standard output, everywhere", "[app]") {
    CHECK(run_keikan("--version").out == "keikan 0.1.0\n");
    for (const std::string command : {"", "render", "scan", "shade", "areas", "pixel", "compare", "info"}) {
        const Run run = run_keikan(command + " --help");
        CHECK(run.exit_code == 0);
        CHECK_THAT(run.out, Catch::Contains("--help"));
        CHECK(run.err.empty());
    }
}

TEST_CASE("keikan: wrong usage is one line and exit code 2", "[app]") {
    refused("", "subcommand");
    refused("paint", "'paint' is not a command");
    refused("render", "required");
    refused("render a.json", "required");
    refused("render a.json -o a.png --colour red", "--colour");
    refused("render " + hill() + " -o - --threads 0", "threads");
    refused("render " + hill() + " -o - --threads two", "threads");
    refused("render " + hill() + " -o - --bits 12", "bits");
    refused("render " + hill() + " -o - --size 10", "WIDTHxHEIGHT");
    refused("render " + hill() + " -o - --size 10x", "WIDTHxHEIGHT");
    refused("render " + hill() + " -o - --size 0x10", "0x10");
    refused("render " + hill() + " -o - --size 99999x99999", "99999x99999");
    refused("render " + hill() + " -o - --size 99999999999x1", "WIDTHxHEIGHT");
    refused("render " + hill() + " -o - --method magic", "magic");
    refused("render " + hill() + " -o - --engine magic", "magic");
    refused("scan " + hill() + " -o x.scan --engine published", "add up to 1");
    refused("render " + hill() + " -o - --extract magic", "magic");
    refused("render " + hill() + " -o - --shadows long", "'long' is none of off, hard, soft");
    refused("shade x.scan " + hill() + " -o - --shadows long", "--shadows");
    refused("render " + hill() + " -o - --aov", ".exr");
    refused("render " + hill() + " -o picture.jpeg", "picture.jpeg");
    refused("areas --engine magic", "magic");
    refused("pixel " + hill() + " --at 10", "X,Y");
    refused("pixel " + hill() + " --at 320,0", "320,0");
    refused("pixel " + hill() + " --at=-1,0", "-1,0");
}

TEST_CASE("keikan: a file that is missing or broken is one line that names it, and exit code 2", "[app]") {
    const ScratchFolder folder("app");
    const std::string missing = folder / "missing.json", broken = folder / "broken.json";
    std::ofstream(broken) << "{\"camera\": ";
    for (const std::string& scene : {missing, broken, folder.path.string()}) {
        refused("render " + scene + " -o -", scene);
        refused("scan " + scene + " -o " + (folder / "a.scan").string(), scene);
        refused("info " + scene, scene);
        refused("pixel " + scene + " --at 1,1", scene);
        refused("areas " + scene, scene);
        refused("shade " + scene + " " + hill() + " -o -", scene);
    }
    CHECK(folder.files() == 1);
}

TEST_CASE("keikan: what cannot be written is exit code 2 and leaves nothing behind", "[app]") {
    const ScratchFolder folder("app");
    const std::string there = folder / "missing";
    refused("render " + hill() + " -o " + there + "/a.png", there + "/a.png");
    refused("render " + hill() + " -o " + there + "/a.exr", there + "/a.exr");
    refused("scan " + hill() + " -o " + there + "/a.scan", there + "/a.scan");
    CHECK(folder.files() == 0);
    if (!std::filesystem::is_character_file("/dev/full")) return;
    refused("render " + hill() + " -o - --quiet >/dev/full", "No space left on device");
    refused("info " + hill() + " >/dev/full", "No space left on device");
    refused("pixel " + hill() + " --at 1,1 >/dev/full", "No space left on device");
    std::filesystem::create_symlink("/dev/full", folder / "full.png");
    std::filesystem::create_symlink("/dev/full", folder / "full.exr");
    std::filesystem::create_symlink("/dev/full", folder / "full.scan");
    refused("render " + hill() + " --quiet -o " + (folder / "full.png").string(), "No space left on device");
    refused("render " + hill() + " --quiet -o " + (folder / "full.exr").string(), "No space left on device");
    refused("scan " + hill() + " --quiet -o " + (folder / "full.scan").string(), "full.scan");
    CHECK(folder.files() == 3);
}

TEST_CASE("keikan: a name that is given keeps its old contents when a run fails", "[app]") {
    const ScratchFolder folder("app");
    const std::string picture = folder / "old.png";
    std::ofstream(picture) << "old\n";
    refused("render " + (folder / "missing.json").string() + " -o " + picture, "missing.json");
    CHECK(contents(picture) == "old\n");
    CHECK(folder.files() == 1);
}
