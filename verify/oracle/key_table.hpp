// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace keikan::oracle {

/// Numbers keys in the order in which they come. Forgetting all of them costs nothing, so that one table
/// serves pixel after pixel.
class KeyTable {
  public:
    struct Key {
        std::uint64_t first, second;
        friend bool operator==(const Key&, const Key&) = default;
    };

    void forget_all() {
        ++round_;
        count_ = 0;
    }

    std::size_t count() const { return count_; }

    /// The place of the value that belongs to `key`: `fresh` if the key is new.
    std::int32_t& value(Key key, std::int32_t fresh) {
        if (2 * (count_ + 1) > slots_.size()) grow();
        Slot& slot = slots_[place_of(key)];
        if (slot.round != round_) {
            slot = {key, round_, fresh};
            ++count_;
        }
        return slot.value;
    }

  private:
    struct Slot {
        Key key{0, 0};
        std::uint64_t round = 0;
        std::int32_t value = 0;
    };

    std::size_t place_of(Key key) const {
        std::uint64_t hash = (key.first ^ (key.second * 0x9e3779b97f4a7c15u)) * 0xff51afd7ed558ccdu;
        hash ^= hash >> 32;
        std::size_t place = hash & (slots_.size() - 1);
        while (slots_[place].round == round_ && slots_[place].key != key)
            place = (place + 1) & (slots_.size() - 1);
        return place;
    }

    void grow() {
        std::vector<Slot> old(slots_.empty() ? 64 : 2 * slots_.size());
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.round == round_) slots_[place_of(slot.key)] = slot;
    }

    std::vector<Slot> slots_;
    std::uint64_t round_ = 1;
    std::size_t count_ = 0;
};

}  // namespace keikan::oracle
