// SPDX-License-Identifier: Apache-2.0
#include "wkt_cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "keikan/support/input_error.hpp"

namespace keikan::cases {

void WktCursor::refuse(const std::string& reason) const {
    if (place_ == Place::Column) throw InputError(name_, fmt::format("column {}", at_ + 1), reason);
    const std::string_view before = text_.substr(0, at_);
    const std::size_t line_start = before.rfind('\n');
    const std::size_t column = at_ - (line_start == before.npos ? 0 : line_start + 1) + 1;
    throw InputError(name_, fmt::format("{}:{}", line(), column), reason);
}

bool WktCursor::accept(char c) {
    skip_space();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
}

void WktCursor::expect(char c) {
    if (!accept(c)) refuse(fmt::format("expected '{}'", c));
}

std::string WktCursor::word() {
    skip_space();
    std::string found;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0)
        found += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
    return found;
}

double WktCursor::number() {
    skip_space();
    const std::string rest(text_.substr(at_, text_.find_first_of(",() \t\r\n", at_) - at_));
    char* end = nullptr;
    const double value = std::strtod(rest.c_str(), &end);
    if (rest.empty() || end != rest.c_str() + rest.size()) refuse("expected a number");
    if (!std::isfinite(value)) refuse("the number is not finite");
    at_ += rest.size();
    return value;
}

bool WktCursor::accept_empty() {
    const std::size_t before = at_;
    if (word() == "EMPTY") return true;
    at_ = before;
    return false;
}

Ring WktCursor::ring() {
    Ring ring;
    expect('(');
    do {
        const double x = number();
        ring.push_back({x, number()});
    } while (accept(','));
    if (at_end() || text_[at_] != ')') refuse("expected ',' or ')'");
    if (ring.size() < 2 || ring.front() != ring.back()) refuse("the ring does not end where it begins");
    ring.pop_back();
    expect(')');
    return ring;
}

Polygon WktCursor::polygon() {
    if (accept_empty()) return {};
    Polygon polygon;
    expect('(');
    polygon.outline = ring();
    while (accept(',')) polygon.holes.push_back(ring());
    expect(')');
    return polygon;
}

std::vector<Polygon> WktCursor::polygons() {
    std::vector<Polygon> polygons;
    if (accept_empty()) return polygons;
    expect('(');
    do polygons.push_back(polygon());
    while (accept(','));
    expect(')');
    return polygons;
}

std::vector<Polygon> WktCursor::geometry() {
    std::vector<Polygon> found;
    std::size_t open = 0;  // collections: counted, not recursed into, so that no text can exhaust the stack
    for (bool more = true; more;) {
        const std::size_t before = at_;
        const std::string kind = word();
        if (kind == "GEOMETRYCOLLECTION" && !accept_empty()) {
            expect('(');
            ++open;
            continue;
        }
        if (kind == "POLYGON") {
            found.push_back(polygon());
        } else if (kind == "MULTIPOLYGON") {
            std::ranges::move(polygons(), std::back_inserter(found));
        } else if (kind != "GEOMETRYCOLLECTION") {
            at_ = before;
            skip_space();
            refuse("expected POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION");
        }
        while (open > 0 && accept(')')) --open;
        more = open > 0;
        if (more) expect(',');
    }
    return found;
}

bool WktCursor::at_end() {
    skip_space();
    return at_ == text_.size();
}

std::string_view WktCursor::skip_comments() {
    std::string_view attributes;
    for (;;) {
        while (accept(';')) {
        }
        if (at_end() || text_[at_] != '#') return attributes;
        const std::string_view line = text_.substr(at_, text_.find('\n', at_) - at_);
        const std::size_t content = line.find_first_not_of(" \t", 1);
        if (content != line.npos && line[content] == '{') attributes = line.substr(content);
        at_ += line.size();
    }
}

std::size_t WktCursor::line() const {
    return 1 + static_cast<std::size_t>(std::ranges::count(text_.substr(0, at_), '\n'));
}

void WktCursor::skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
}

}  // namespace keikan::cases
