// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/campaign_journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "fuzz/summary_json.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan::fuzz {
namespace {

using Json = nlohmann::json;

constexpr int kFormat = 1;

[[noreturn]] void fail(const std::filesystem::path& file, const char* what, int error) {
    throw InputError(file.string(), "", what + (": " + std::generic_category().message(error)));
}

Json json_of_state(const CampaignState& state, std::uint64_t found_bytes) {
    Json json{{"format", kFormat},          {"identity", state.identity}, {"first", state.first},
              {"done", state.done},         {"finished", state.finished}, {"seconds", state.seconds},
              {"findings", state.findings}, {"found_bytes", found_bytes}, {"shrunk", state.shrunk},
              {"stored", state.stored},     {"summaries", Json::array()}};
    for (const auto& summary : state.summaries) json["summaries"].push_back(json_of(summary));
    return json;
}

CampaignState state_of(const Json& json) {
    CampaignState state;
    state.identity = json.at("identity").get<CampaignIdentity>();
    state.first = json.at("first");
    state.done = json.at("done");
    state.finished = json.at("finished");
    state.seconds = json.at("seconds");
    state.findings = json.at("findings");
    state.shrunk = json.at("shrunk").get<std::map<std::string, std::uint64_t>>();
    state.stored = json.at("stored").get<std::set<std::string>>();
    for (const Json& summary : json.at("summaries")) state.summaries.push_back(summary_of(summary));
    return state;
}

/// The committed state as JSON; null where there is none.
Json committed_json(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return {};
    try {
        Json json = Json::parse(in);
        if (json.at("format") != kFormat)
            throw InputError(file.string(), "", "was written by another version of keikan-verify");
        return json;
    } catch (const Json::exception& error) {
        throw InputError(file.string(), "", std::string("is not the state of a campaign: ") + error.what());
    }
}

}  // namespace

CampaignJournal::CampaignJournal(const std::filesystem::path& folder) : folder_(folder / "campaign") {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw InputError(folder_.string(), "", "cannot be made: " + error.message());
    const auto lock_file = folder_ / "lock", found_file = folder_ / "found.log";
    lock_ = open(lock_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock_ < 0) fail(lock_file, "cannot be opened", errno);
    // The system gives the lock back when the process ends, however it ends.
    if (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
        const int reason = errno;
        close(lock_);
        if (reason == EWOULDBLOCK) throw InputError(folder_.string(), "", "another campaign is at work here");
        fail(lock_file, "cannot be locked", reason);
    }
    found_ = open(found_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (found_ < 0) {
        const int reason = errno;
        close(lock_);
        fail(found_file, "cannot be opened", reason);
    }
}

CampaignJournal::~CampaignJournal() {
    close(found_);
    close(lock_);
}

std::optional<CampaignState> CampaignJournal::committed() const {
    const Json json = committed_json(state_file());
    if (json.is_null()) return std::nullopt;
    try {
        return state_of(json);
    } catch (const Json::exception& error) {
        throw InputError(state_file().string(), "",
                         std::string("is not the state of a campaign: ") + error.what());
    }
}

void CampaignJournal::begin(const CampaignState& state) {
    const Json json = committed_json(state_file());
    found_bytes_ = json.is_null() ? 0 : json.at("found_bytes").get<std::uint64_t>();
    if (ftruncate(found_, static_cast<off_t>(found_bytes_)) != 0)
        fail(folder_ / "found.log", "cannot be cut to its length", errno);
    commit(state, "");
}

void CampaignJournal::commit(const CampaignState& state, const std::string& lines) {
    for (std::size_t written = 0; written < lines.size();) {
        const ssize_t count = pwrite(found_, lines.data() + written, lines.size() - written,
                                     static_cast<off_t>(found_bytes_ + written));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(folder_ / "found.log", "cannot be written", errno);
        written += static_cast<std::size_t>(count);
    }
    found_bytes_ += lines.size();
    write_whole_file(state_file(), json_of_state(state, found_bytes_).dump() + "\n");
}

}  // namespace keikan::fuzz
