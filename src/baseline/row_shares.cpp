// SPDX-License-Identifier: Apache-2.0
#include "row_shares.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keikan::baseline {

void add_share(std::vector<Share>& shares, std::uint32_t face, double weight, double x, double y) {
    for (std::size_t i = shares.size(); i-- > 0;)
        if (shares[i].face == face) {
            shares[i].add(weight, x, y);
            if (i + 1 < shares.size()) std::swap(shares[i], shares.back());
            return;
        }
    shares.push_back({face, 0, 0, 0});
    shares.back().add(weight, x, y);
}

void put_pixel(BandBuilder& builder, int row, int x, std::span<const Share> shares, double total,
               std::vector<SeenPart>& parts) {
    double rest = total;
    for (const Share& share : shares) rest -= share.weight;
    const double nothing = kShareRounding * total;
    if (shares.empty() || rest >= total - nothing)
        return builder.add_span(row, x, x + 1, BandBuilder::kBackground);
    if (shares.size() == 1 && rest <= nothing) return builder.add_span(row, x, x + 1, shares[0].face);
    parts.clear();
    for (const Share& share : shares) {
        if (!(share.weight > nothing)) continue;
        const auto within = [&](double sum) {
            return static_cast<float>(std::clamp(sum / share.weight, 0.0, 1.0));
        };
        parts.push_back({share.face, within(share.x), within(share.y), std::min(share.weight / total, 1.0)});
    }
    std::sort(parts.begin(), parts.end(),
              [](const SeenPart& p, const SeenPart& q) { return p.face < q.face; });
    builder.add_divided(row, x, Division::Scanline, parts, rest > nothing ? rest / total : 0);
}

void RowShares::add(std::span<const Stretch> stretches, double y, double weight) {
    for (const Stretch& s : stretches) {
        const int first = static_cast<int>(s.begin);
        const int last =
            std::min(static_cast<int>(std::ceil(s.end)) - 1, static_cast<int>(pixels_.size()) - 1);
        for (int x = first; x <= last; ++x) {
            const double begin = x == first ? s.begin - x : 0, end = x == last ? s.end - x : 1;
            add_share(pixels_[static_cast<std::size_t>(x)], s.face, weight * (end - begin), (begin + end) / 2,
                      y);
        }
    }
}

void RowShares::clear() {
    for (auto& shares : pixels_) shares.clear();
}

}  // namespace keikan::baseline
