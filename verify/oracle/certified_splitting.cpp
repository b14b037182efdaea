// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_areas.hpp"

namespace keikan::oracle {

struct CertifiedSplitting::Working {};

CertifiedSplitting::CertifiedSplitting() : working_(new Working) {}
CertifiedSplitting::~CertifiedSplitting() { delete working_; }

CertifiedAreas CertifiedSplitting::operator()(PixelIndex, std::span<const FaceView>, Nearness) { return {}; }

}  // namespace keikan::oracle
