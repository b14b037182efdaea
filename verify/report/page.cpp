// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page.hpp"

#include <CGAL/version.h>
#include <fmt/format.h>
#include <gmp.h>

#include <nlohmann/json.hpp>
#include <system_error>

#include "keikan/support/atomic_file.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/input_error.hpp"
#include "report/packed_bytes.hpp"
#include "report/page_template.hpp"

namespace keikan::report {
namespace {

using Json = nlohmann::ordered_json;

std::string compiler() {
#if defined(__clang__)
    return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
    return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

/// JSON that cannot end the element it stands in: '<' is found in strings alone.
std::string harmless(const std::string& json) {
    std::string result;
    result.reserve(json.size());
    for (const char c : json) {
        if (c == '<')
            result += "\\u003c";
        else
            result += c;
    }
    return result;
}

std::string element(const char* id, const std::string& content) {
    return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, harmless(content));
}

std::string head_json(const Page& page, std::uint64_t left_out) {
    Json errors{{"none", page.errors.none}, {"bins", page.errors.bins}, {"beyond", page.errors.beyond}};
    Json head{{"kind", page.kind},
              {"subject", page.subject},
              {"command", page.command},
              {"scene", page.scene},
              {"size", page.size},
              {"engine", page.engine},
              {"seed", page.seed},
              {"versions",
               {{"keikan", page.version},
                {"CGAL", CGAL_VERSION_STR},
                {"GMP", gmp_version},
                {"compiler", compiler()}}},
              {"errors", std::move(errors)},
              {"left_out", left_out},
              {"disagreeing_left_out", page.disagreeing_left_out},
              {"more", Json::parse(page.more)},
              {"summary", Json::parse(page.summary)}};
    return head.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void make_report_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && !std::filesystem::is_directory(folder))
        error = std::make_error_code(std::errc::not_a_directory);
    if (error) throw InputError(folder.string(), "", "cannot be made: " + error.message());
}

std::string html_of(const Page& page) {
    constexpr std::string_view kMark = "<!--data-->";
    const std::size_t at = kPageTemplate.find(kMark);
    KEIKAN_CHECK(at != std::string_view::npos, "the page has no place for its data");
    std::string html(kPageTemplate.substr(0, at));
    const PixelDetails details = pixel_details_json(page.pixels);
    html += element("report-head", head_json(page, details.left_out));
    html += element("report-picture", page.picture.empty() ? "null" : page.picture);
    html += element("report-pixels", Json(packed(details.json)).dump());
    html += kPageTemplate.substr(at + kMark.size());
    return html;
}

void write_page(const std::filesystem::path& folder, const Page& page) {
    const double seconds = Json::parse(page.summary).value("seconds", 0.0);
    write_whole_file(folder / "index.html", html_of(page));
    write_whole_file(folder / "summary.json", page.summary + "\n");
    write_whole_file(folder / "junit.xml",
                     junit_xml("keikan-verify " + page.kind + " " + page.subject, page.junit, seconds));
}

}  // namespace keikan::report
