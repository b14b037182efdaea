// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "input_stream.hpp"
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/parallel.hpp"
#include "option_values.hpp"

namespace keikan {

namespace {

struct AreasCommand {
    std::string file = "-", engine = "splitting";
};

/// Appends {"id": ..., "areas": [...], "background": ...} and a line end; one area for each polygon.
void append_answer(std::string& out, const PixelCase& question, VisibleAreas& visible_areas) {
    const std::vector<FaceView> faces = question.faces();
    const PixelCoverage seen = visible_areas(question.pixel, faces, question.nearness());
    std::vector<double> areas(faces.size(), 0.0);
    for (const VisiblePart& part : seen.parts) areas[part.face] = part.area;
    fmt::format_to(std::back_inserter(out), "{{\"id\": {}, \"areas\": [", nlohmann::json(question.id).dump());
    for (std::size_t i = 0; i < areas.size(); ++i)
        fmt::format_to(std::back_inserter(out), "{}{:.17g}", i == 0 ? "" : ", ", areas[i]);
    fmt::format_to(std::back_inserter(out), "], \"background\": {:.17g}}}\n", seen.background);
}

/// Answers questions in pieces of the list, side by side, each piece with its own working memory.
class Answers {
  public:
    explicit Answers(Engine engine) : texts_(4 * static_cast<std::size_t>(thread_count())) {
        for (std::size_t i = 0; i < texts_.size(); ++i) engines_.emplace_back(engine);
    }

    /// The answers as text, in the order of the questions.
    const std::vector<std::string>& to(const std::vector<PixelCase>& questions) {
        const std::size_t pieces = engines_.size();
        parallel_for(pieces, [&](std::size_t piece) {
            texts_[piece].clear();
            const std::size_t end = questions.size() * (piece + 1) / pieces;
            for (std::size_t i = questions.size() * piece / pieces; i < end; ++i)
                append_answer(texts_[piece], questions[i], engines_[piece]);
        });
        return texts_;
    }

  private:
    std::vector<VisibleAreas> engines_;
    std::vector<std::string> texts_;
};

void areas(const AreasCommand& command, const CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    constexpr std::size_t kMostAtOnce = 1024;
    InputStream in(command.file);
    PixelCaseReader reader(in, in.name());
    AtomicFile out("-");
    Answers answers(engine_of(command.engine));
    std::vector<PixelCase> questions;
    std::exception_ptr bad_line;
    for (bool more = true; more;) {
        questions.clear();
        try {
            // A quiet pipe gets its answers before it is waited for: the other end may be waiting for them.
            do {
                std::optional<PixelCase> question = reader.next();
                more = question.has_value();
                if (more) questions.push_back(*std::move(question));
            } while (more && questions.size() < kMostAtOnce && in.rdbuf()->in_avail() > 0);
        } catch (...) {
            bad_line = std::current_exception();  // after the answers to the lines before it
            more = false;
        }
        for (const std::string& text : answers.to(questions)) out.write(text);
    }
    if (bad_line) std::rethrow_exception(bad_line);
    out.finish();
}

}  // namespace

void add_areas_command(CLI::App& app, const CommonOptions& common) {
    auto* const sub =
        app.add_subcommand("areas", "Visible areas of pixel cases (docs/cases.md), a line of JSON each");
    const auto command = std::make_shared<AreasCommand>();
    sub->add_option("FILE", command->file, "Pixel cases, or - for standard input")->capture_default_str();
    sub->add_option("--engine", command->engine, "splitting, traversal, published")->capture_default_str();
    sub->callback([command, &common] { areas(*command, common); });
}

}  // namespace keikan
