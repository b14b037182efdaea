// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "keikan/cases/polygon.hpp"

namespace keikan::cases {

/// A place in a well-known text. Every step skips white space before it.
class WktCursor {
  public:
    /// How a place is named in messages.
    enum class Place {
        Column,         ///< "column 7": the text is one line of a command
        LineAndColumn,  ///< "3:7": the text is a file
    };
    WktCursor(std::string_view text, const std::string& name, Place place, std::size_t at = 0)
        : text_(text), name_(name), place_(place), at_(at) {}

    [[noreturn]] void refuse(const std::string& reason) const;
    bool accept(char c);
    void expect(char c);
    /// The next word, in capitals; empty where there is none.
    std::string word();
    double number();

    /// Behind POLYGON: the rings in their brackets, or EMPTY. Repeated points are kept.
    Polygon polygon();
    /// Behind MULTIPOLYGON.
    std::vector<Polygon> polygons();
    /// The polygons of one geometry, of whatever kind.
    std::vector<Polygon> geometry();

    bool at_end();
    /// Skips white space, ';', and lines that begin with '#'; the last "# {" line is what follows "# " in it.
    std::string_view skip_comments();

    std::size_t at() const { return at_; }
    /// Of the place, counted from 1.
    std::size_t line() const;

  private:
    void skip_space();
    bool accept_empty();
    Ring ring();

    std::string_view text_;
    const std::string& name_;
    Place place_;
    std::size_t at_ = 0;
};

}  // namespace keikan::cases
