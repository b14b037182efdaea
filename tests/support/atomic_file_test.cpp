// SPDX-License-Identifier: Apache-2.0
#include "keikan/support/atomic_file.hpp"

#include <unistd.h>
#include <catch2/catch.hpp>
#include <iterator>

#include "file_contents.hpp"
#include "keikan/support/input_error.hpp"
#include "scratch_folder.hpp"

using namespace keikan;
namespace fs = std::filesystem;

TEST_CASE("AtomicFile: the file appears when it is finished, and not before", "[support]") {
    const ScratchFolder folder;
    const fs::path file = folder.path / "picture.png";
    AtomicFile out(file);
    out.write("one ");
    out.write("two");
    CHECK(out.size() == 7);
    out.overwrite(0, std::as_bytes(std::span("ONE", 3)));
    CHECK_FALSE(fs::exists(file));
    out.finish();
    CHECK(contents(file) == "ONE two");
    CHECK(folder.files() == 1);
}

TEST_CASE("AtomicFile: unfinished work leaves what was there, and nothing else", "[support]") {
    const ScratchFolder folder;
    const fs::path file = folder.path / "picture.png";
    write_whole_file(file, "before");
    {
        AtomicFile out(file);
        out.write("half");
    }
    CHECK(contents(file) == "before");
    CHECK(folder.files() == 1);
    write_whole_file(file, "after");
    CHECK(contents(file) == "after");
}

TEST_CASE("AtomicFile: a symbolic link keeps pointing at the file that is replaced", "[support]") {
    const ScratchFolder folder;
    write_whole_file(folder.path / "real", "before");
    fs::create_symlink("real", folder.path / "link");
    write_whole_file(folder.path / "link", "after");
    CHECK(fs::is_symlink(folder.path / "link"));
    CHECK(contents(folder.path / "real") == "after");
}

TEST_CASE("AtomicFile: what cannot be written is bad input that names the file", "[support]") {
    const ScratchFolder folder;
    const auto refused = [](const fs::path& file, const std::string& reason) {
        CHECK_THROWS_WITH(write_whole_file(file, "x"), file.string() + ": cannot be written: " + reason);
        CHECK_THROWS_AS(write_whole_file(file, "x"), InputError);
    };
    refused(folder.path / "missing" / "a", "No such file or directory");
    refused(folder.path, "it is a folder");
    CHECK_THROWS_AS(write_whole_file("", "x"), InputError);
    CHECK(folder.files() == 0);
    if (fs::is_character_file("/dev/full")) {
        refused("/dev/full", "No space left on device");
        CHECK(fs::is_character_file("/dev/full"));
    }
}
