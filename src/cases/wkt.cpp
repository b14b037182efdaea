// SPDX-License-Identifier: Apache-2.0
#include "keikan/cases/wkt.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <cstdlib>

#include "keikan/support/input_error.hpp"

namespace keikan {

namespace {

/// A place in the text. Every step skips white space before it.
class WktCursor {
  public:
    WktCursor(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    [[noreturn]] void refuse(const std::string& reason) const {
        throw InputError(name_, fmt::format("column {}", at_ + 1), reason);
    }
    bool accept(char c) {
        skip_space();
        if (at_ == text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    void expect(char c) {
        if (!accept(c)) refuse(fmt::format("expected '{}'", c));
    }
    /// The next word, in capitals; empty where there is none.
    std::string word() {
        skip_space();
        std::string found;
        while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0)
            found += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
        return found;
    }
    double number() {
        skip_space();
        const std::string rest(text_.substr(at_, text_.find_first_of(",() \t\r\n", at_) - at_));
        char* end = nullptr;
        const double value = std::strtod(rest.c_str(), &end);
        if (rest.empty() || end != rest.c_str() + rest.size()) refuse("expected a number");
        if (!std::isfinite(value)) refuse("the number is not finite");
        at_ += rest.size();
        return value;
    }
    void expect_end() {
        skip_space();
        if (at_ != text_.size()) refuse("something follows the polygon");
    }

  private:
    void skip_space() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    }
    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0;
};

}  // namespace

Ring ring_from_wkt(std::string_view text, const std::string& name) {
    WktCursor cursor(text, name);
    if (cursor.word() != "POLYGON") cursor.refuse("expected POLYGON ((x y, x y, ...))");
    Ring ring;
    if (cursor.word() == "EMPTY") {
        cursor.expect_end();
        return ring;
    }
    cursor.expect('(');
    cursor.expect('(');
    std::size_t points = 0;
    Point first;
    Point last;
    do {
        last.x = cursor.number();
        last.y = cursor.number();
        if (points++ == 0) first = last;
        if (ring.empty() || ring.back() != last) ring.push_back(last);
    } while (cursor.accept(','));
    if (first != last || points < 2) cursor.refuse("the ring does not end where it begins");
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    cursor.expect(')');
    if (cursor.accept(',')) cursor.refuse("a polygon with holes is not one ring");
    cursor.expect(')');
    cursor.expect_end();
    return ring;
}

std::string wkt_from_ring(const Ring& ring) {
    if (ring.empty()) return "POLYGON EMPTY";
    std::string text = "POLYGON ((";
    for (const Point p : ring) text += fmt::format("{:.17g} {:.17g}, ", p.x, p.y);
    return text + fmt::format("{:.17g} {:.17g}))", ring[0].x, ring[0].y);
}

}  // namespace keikan
