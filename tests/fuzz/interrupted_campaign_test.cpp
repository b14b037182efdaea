// SPDX-License-Identifier: GPL-3.0-or-later
//
// Campaigns that are killed, as a power cut would: kill -9 at random moments.
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <thread>

#include "../support/file_contents.hpp"
#include "../support/scratch_folder.hpp"

namespace {

using nlohmann::json;

/// keikan-verify on an engine with many findings, saving into `folder`.
class Campaign {
  public:
    explicit Campaign(const std::filesystem::path& folder) {
        const std::string save = folder.string(), summary = summary_file(folder).string();
        const char* arguments[] = {KEIKAN_VERIFY_PROGRAM,
                                   "fuzz",
                                   "--engine",
                                   "published",
                                   "--family",
                                   "grid4,notch",
                                   "--count",
                                   "4096",
                                   "--no-contacts",
                                   "--quiet",
                                   "--shrink",
                                   "12",
                                   "--resume",
                                   "--save",
                                   save.c_str(),
                                   "--json",
                                   summary.c_str(),
                                   nullptr};
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", 1 /* O_WRONLY */, 0);
        const int failed = posix_spawn(&process_, KEIKAN_VERIFY_PROGRAM, &actions, nullptr,
                                       const_cast<char* const*>(arguments), environ);
        posix_spawn_file_actions_destroy(&actions);
        REQUIRE(failed == 0);
    }

    /// Its exit code, or nothing if it was killed after so many milliseconds.
    std::optional<int> end(std::optional<int> killed_after_ms) {
        int status = 0;
        if (killed_after_ms) {
            std::this_thread::sleep_for(std::chrono::milliseconds(*killed_after_ms));
            kill(process_, SIGKILL);
        }
        waitpid(process_, &status, 0);
        return WIFEXITED(status) ? std::optional(WEXITSTATUS(status)) : std::nullopt;
    }

    static std::filesystem::path summary_file(const std::filesystem::path& folder) {
        return folder.string() + ".json";
    }

  private:
    pid_t process_ = 0;
};

/// What a campaign left: its summary without the seconds, and the bytes of its findings.
std::map<std::string, std::string> result_of(const std::filesystem::path& folder) {
    std::map<std::string, std::string> result;
    json summary = json::parse(contents(Campaign::summary_file(folder)));
    summary.erase("seconds");
    result["summary"] = summary.dump();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().filename() != "state.json" &&
            entry.path().extension() != ".tmp")  // what AtomicFile was writing when it was killed
            result[entry.path().filename().string()] = contents(entry.path());
    return result;
}

}  // namespace

TEST_CASE("keikan-verify fuzz --resume: killed again and again, it ends with the same counts and findings",
          "[fuzz][campaign][kill]") {
    const ScratchFolder folder("killed");
    const auto start = std::chrono::steady_clock::now();
    REQUIRE(Campaign(folder / "whole").end(std::nullopt) == 1);  // findings: exit code 1
    const auto whole_ms =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start)
            .count();

    // Random moments, so that every step is hit in one run or another; the message names them.
    std::random_device device;
    int kills = 0;
    std::string moments;
    for (bool ended = false; !ended;) {
        std::optional<int> moment;
        if (kills < 6) moment = static_cast<int>(device() % static_cast<unsigned>(whole_ms / 3 + 20));
        const std::optional<int> code = Campaign(folder / "killed").end(moment);
        if (moment) moments += std::to_string(*moment) + " ";
        kills += !code;
        ended = code.has_value();
        if (code) CHECK(*code == 1);
    }
    INFO("killed after milliseconds " << moments);
    CHECK(kills >= 3);
    CHECK(result_of(folder / "killed") == result_of(folder / "whole"));
    CHECK(result_of(folder / "whole").size() > 40);
}
