// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/support/input_error.hpp"
#include "peers/child_program.hpp"
#include "peers/contestant.hpp"

namespace keikan::peers {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostAtOnce = 256;
constexpr int kMostFailuresInARow = 64;
/// For one case; answers are about a fifth as long as questions.
constexpr std::size_t kMostOutput = std::size_t{1} << 20;
constexpr int kNotExecutable = 126, kNotFound = 127;  // the shell's exit codes

Reply no_answer(std::string reason) {
    return {Outcome::Exception, std::move(reason), {}};
}

std::string shown(std::string_view line) {
    return fmt::format("'{}{}'", line.substr(0, 80), line.size() > 80 ? "..." : "");
}

/// What a line of output says about a case.
Reply reply_in(std::string_view line, const PixelCase& asked) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object()) return no_answer("wrote no JSON object: " + shown(line));
    if (json.contains("id") && json["id"] != asked.id)
        return no_answer("answers another case: " + shown(line));
    const Json areas = json.value("areas", Json()), background = json.value("background", Json());
    const auto is_finite = [](const Json& n) { return n.is_number() && std::isfinite(n.get<double>()); };
    if (!areas.is_array() || areas.size() != asked.polygons.size() ||
        !std::ranges::all_of(areas, is_finite) || !is_finite(background))
        return no_answer("wrote no areas: " + shown(line));
    return {Outcome::Answered, "", {areas.get<std::vector<double>>(), background.get<double>()}};
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (end > 0) lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

class ExternalProgram {
  public:
    ExternalProgram(std::string command, const Watchdog& watchdog)
        : command_(std::move(command)), watchdog_(watchdog) {}

    Round operator()(const Batch& batch) {
        Round round;
        const std::span<const PixelCase> cases = batch.cases;
        while (round.replies.size() < cases.size() && !given_up())
            ask_some(cases.subspan(round.replies.size()), round);
        round.replies.resize(cases.size());
        return round;
    }

  private:
    bool given_up() const {
        return hangs_ >= watchdog_.most_hangs || failures_in_a_row_ >= kMostFailuresInARow;
    }

    /// Asks about the first few of `cases`, and takes of the replies what is certain: all, the answers before
    /// something went wrong, or, of a case that stood alone, what went wrong.
    void ask_some(std::span<const PixelCase> cases, Round& round) {
        cases = cases.first(std::min(at_once_, cases.size()));
        std::string input;
        for (PixelCase question : cases) {
            question.areas.reset();
            question.background.reset();
            input += pixel_case_line(question) + "\n";
        }
        const ProgramRun run =
            run_program(command_, input, watchdog_.seconds, kMostOutput + 4 * input.size());
        if (run.exit_code == kNotFound || run.exit_code == kNotExecutable)
            throw InputError("--exec " + command_ + ": the shell cannot run it: " + run.last_complaint);
        const std::vector<std::string_view> lines = lines_of(run.output);
        const bool ended_well = !run.stopped && run.signal == 0 && run.exit_code == 0;
        if (ended_well && lines.size() == cases.size()) {
            for (std::size_t i = 0; i < cases.size(); ++i) take(reply_in(lines[i], cases[i]), round);
            round.seconds += run.processor_seconds;
            round.timed_pixels += cases.size();
            at_once_ = std::min(2 * at_once_, kMostAtOnce);
            return;
        }
        if (cases.size() == 1) return take(failure(run, lines), round);
        std::vector<Reply> certain;
        while (certain.size() < std::min(lines.size(), cases.size())) {
            Reply reply = reply_in(lines[certain.size()], cases[certain.size()]);
            if (reply.outcome != Outcome::Answered) break;
            certain.push_back(std::move(reply));
        }
        if (certain.size() == cases.size())
            certain.clear();  // whose fault the bad end is, is to be found out
        at_once_ = std::max<std::size_t>(1, (cases.size() - certain.size()) / 2);
        for (Reply& reply : certain) take(std::move(reply), round);
    }

    void take(Reply reply, Round& round) {
        hangs_ += reply.outcome == Outcome::Hang;
        failures_in_a_row_ = reply.outcome == Outcome::Answered ? 0 : failures_in_a_row_ + 1;
        round.replies.push_back(std::move(reply));
    }

    static Reply failure(const ProgramRun& run, const std::vector<std::string_view>& lines) {
        if (run.stopped) return {Outcome::Hang, "stopped at the time limit", {}};
        if (run.signal != 0) return {Outcome::Crash, signal_in_words(run.signal), {}};
        if (run.exit_code != 0)
            return no_answer(fmt::format("exit code {}: {}", run.exit_code, run.last_complaint));
        return no_answer(fmt::format("wrote {} lines for one case{}{}", lines.size(),
                                     lines.empty() ? "" : ": ", lines.empty() ? "" : shown(lines.front())));
    }

    std::string command_;
    Watchdog watchdog_;
    std::size_t at_once_ = kMostAtOnce;
    int hangs_ = 0;
    int failures_in_a_row_ = 0;
};

}  // namespace

Contestant external_program(const std::string& name, const std::string& command, const Watchdog& watchdog) {
    const auto program = std::make_shared<ExternalProgram>(command, watchdog);
    return {name, command, false, {}, [program](const Batch& batch) { return (*program)(batch); }};
}

}  // namespace keikan::peers
