// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "contact_names.hpp"
#include "input_stream.hpp"
#include "keikan/cases/pixel_case_file.hpp"
#include "keikan/clip/visible_areas.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"
#include "keikan/support/parallel.hpp"
#include "option_values.hpp"

namespace keikan {

namespace {

struct AreasCommand {
    std::string file = "-", engine = "splitting";
    bool outlines = false;
};

/// Answers questions one after the other, and keeps what --outlines shows beside the areas.
class Answerer {
  public:
    Answerer(Engine engine, bool outlines) : visible_areas_(engine), outlines_(outlines) {
        if (!outlines_) return;
        visible_areas_.observe([this](const ClipStep& step) {
            for (const Contact& contact : step.contacts)
                if (std::ranges::find(contacts_, contact) == contacts_.end()) contacts_.push_back(contact);
        });
    }

    /// Appends {"id": ..., "areas": [...], "background": ...} and a line end; one area for each polygon.
    void append_answer(std::string& out, const PixelCase& question);

  private:
    void append_outlines(std::string& out);

    VisibleAreas visible_areas_;
    bool outlines_;
    std::vector<Contact> contacts_;  ///< of the question being answered
};

void Answerer::append_answer(std::string& out, const PixelCase& question) {
    contacts_.clear();
    const std::vector<FaceView> faces = question.faces();
    const PixelCoverage seen = visible_areas_(question.pixel, faces, question.nearness());
    std::vector<double> areas(faces.size(), 0.0);
    for (const VisiblePart& part : seen.parts) areas[part.face] = part.area;
    fmt::format_to(std::back_inserter(out), "{{\"id\": {}, \"areas\": [", nlohmann::json(question.id).dump());
    for (std::size_t i = 0; i < areas.size(); ++i)
        fmt::format_to(std::back_inserter(out), "{}{:.17g}", i == 0 ? "" : ", ", areas[i]);
    fmt::format_to(std::back_inserter(out), "], \"background\": {:.17g}", seen.background);
    if (outlines_) append_outlines(out);
    out += "}\n";
}

/// The visible outlines, pixel-local (face null: the background), and where outlines met along the way.
void Answerer::append_outlines(std::string& out) {
    const auto to = std::back_inserter(out);
    out += ", \"outlines\": [";
    const char* comma = "";
    for (const VisibleOutline& outline : visible_areas_.outlines()) {
        const std::string face =
            outline.face == VisiblePiece::kBackground ? "null" : fmt::format("{}", outline.face);
        fmt::format_to(to, "{}{{\"face\": {}, \"sign\": {}, \"ring\": [", comma, face, outline.sign);
        comma = "";
        for (const Point p : outline.ring) {
            fmt::format_to(to, "{}[{:.17g}, {:.17g}]", comma, p.x, p.y);
            comma = ", ";
        }
        out += "]}";
        comma = ", ";
    }
    out += "], \"contacts\": [";
    comma = "";
    for (const Contact& c : contacts_) {
        fmt::format_to(to, "{}{{\"class\": \"{}\", \"turn\": \"{}\", \"point\": [{:.17g}, {:.17g}]}}", comma,
                       name_of(c.kind), name_of(c.turn), c.point.x, c.point.y);
        comma = ", ";
    }
    out += "]";
}

/// Answers questions in pieces of the list, side by side, each piece with its own working memory.
class Answers {
  public:
    Answers(Engine engine, bool outlines) : texts_(4 * static_cast<std::size_t>(thread_count())) {
        for (std::size_t i = 0; i < texts_.size(); ++i)
            answerers_.push_back(std::make_unique<Answerer>(engine, outlines));
    }

    /// The answers as text, in the order of the questions.
    const std::vector<std::string>& to(const std::vector<PixelCase>& questions) {
        const std::size_t pieces = answerers_.size();
        parallel_for(pieces, [&](std::size_t piece) {
            texts_[piece].clear();
            const std::size_t end = questions.size() * (piece + 1) / pieces;
            for (std::size_t i = questions.size() * piece / pieces; i < end; ++i)
                answerers_[piece]->append_answer(texts_[piece], questions[i]);
        });
        return texts_;
    }

  private:
    std::vector<std::unique_ptr<Answerer>> answerers_;
    std::vector<std::string> texts_;
};

void areas(const AreasCommand& command, const CommonOptions& common) {
    const ThreadLimit threads(common.threads);
    constexpr std::size_t kMostAtOnce = 1024;
    InputStream in(command.file);
    PixelCaseReader reader(in, in.name());
    AtomicFile out("-");
    const Engine engine = engine_of(command.engine);
    if (command.outlines && engine != Engine::Traversal)
        throw InputError("--outlines: only --engine traversal has them");
    Answers answers(engine, command.outlines);
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
    sub->add_flag("--outlines", command->outlines,
                  "With --engine traversal: the visible outlines and the contacts of the clipping too");
    sub->callback([command, &common] { areas(*command, common); });
}

}  // namespace keikan
