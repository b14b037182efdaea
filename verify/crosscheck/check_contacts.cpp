// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "keikan/clip/visible_areas.hpp"
#include "oracle/exact_intersections.hpp"
#include "oracle/lattice_intersections.hpp"

namespace keikan::crosscheck {
namespace {

std::string text_of(const Contact& contact) {
    constexpr const char* kClasses[] = {"edge-edge", "subject-vertex", "clip-vertex", "shared-vertex"};
    constexpr const char* kTurns[] = {"enter", "leave", "touch"};
    return fmt::format("{} {} at subject {}, clip {}", kClasses[static_cast<int>(contact.kind)],
                       kTurns[static_cast<int>(contact.turn)], contact.subject, contact.clip);
}

bool same(const Contact& a, const Contact& b) {
    return a.kind == b.kind && a.turn == b.turn && a.subject == b.subject && a.clip == b.clip;
}

}  // namespace

std::optional<std::string> contact_mismatch(const ClipStep& step, std::span<const Contact> exact) {
    const std::size_t both = std::min(step.contacts.size(), exact.size());
    for (std::size_t i = 0; i < both; ++i)
        if (!same(step.contacts[i], exact[i]))
            return fmt::format("contact {}: {}, exactly {}", i, text_of(step.contacts[i]), text_of(exact[i]));
    if (step.contacts.size() != exact.size())
        return fmt::format("{} contacts, exactly {}", step.contacts.size(), exact.size());
    return std::nullopt;
}

struct ContactCheck::Working {
    VisibleAreas traversal{Engine::Traversal};
    oracle::LatticeIntersections quick;
    PixelIndex pixel;
    PixelVerdict* verdict = nullptr;
    bool by_constructions = false;
    std::optional<KindsOfPixel> kinds;

    explicit Working(bool with_kinds) {
        if (with_kinds) kinds.emplace();
        traversal.observe([this](const ClipStep& step) {
            check(step);
            if (kinds) kinds->take(step);
        });
    }

    void disagree(Disagreement::Kind kind, const std::string& note) {
        verdict->disagreements.push_back({.kind = kind, .pixel = pixel, .note = note});
    }

    void check(const ClipStep& step) {
        const auto counted = quick(step.subject, step.clip);
        std::optional<std::string> mismatch;
        if (counted) mismatch = contact_mismatch(step, *counted);
        std::size_t contacts = counted ? counted->size() : 0;
        if (!counted || mismatch || by_constructions) {
            const std::vector<Contact> exact = oracle::exact_intersections(step.subject, step.clip);
            ++verdict->contacts.constructed;
            if (counted && contact_mismatch({step.subject, step.clip, *counted}, exact))
                disagree(Disagreement::Kind::Rungs, "contacts by constructions and in whole numbers differ");
            mismatch = contact_mismatch(step, exact);
            contacts = exact.size();
        }
        verdict->contacts.checked += contacts;
        if (!mismatch) return;
        ++verdict->contacts.mismatches;
        disagree(Disagreement::Kind::Contact, *mismatch);
    }
};

ContactCheck::ContactCheck(bool kinds) : working_(std::make_unique<Working>(kinds)) {}
ContactCheck::~ContactCheck() = default;
ContactCheck::ContactCheck(ContactCheck&&) noexcept = default;
ContactCheck& ContactCheck::operator=(ContactCheck&&) noexcept = default;

PixelCoverage ContactCheck::operator()(const Question& question, PixelVerdict& verdict,
                                       bool by_constructions) {
    working_->by_constructions = by_constructions;
    working_->pixel = question.pixel;
    working_->verdict = &verdict;
    if (working_->kinds) working_->kinds->start();
    const std::uint64_t folds = working_->traversal.statistics().folds;
    const PixelCoverage coverage = working_->traversal(question.pixel, question.faces, question.nearness);
    verdict.contacts.folds += working_->traversal.statistics().folds - folds;
    if (working_->kinds) verdict.kinds = working_->kinds->kinds(working_->traversal.outlines());
    return coverage;
}

}  // namespace keikan::crosscheck
